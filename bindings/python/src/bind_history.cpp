#include "array_out.hpp"
#include "bind.hpp"
#include "elements.hpp"
#include "held_results.hpp"

#include <abut/contact_history.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

namespace abut::python {

namespace {

/// Values of any size for the contacts of each step: bytes that the caller gives a meaning.
class ByteHistory {
 public:
  explicit ByteHistory(std::size_t value_bytes) : value_bytes_(value_bytes) {}

  /// Takes the contacts of a step. The values of kept contacts are copied from `before`, the array
  /// of the last step, to `after`, which holds a value for each pair and zeros at first.
  void update(const PairResults& pairs, const Elements& elements, const Domain& domain,
              std::span<const std::uint64_t> ids) {
    places_.update(pairs.list(), elements.view(), domain, ids);
    before_.assign(places_.values().begin(), places_.values().end());
    lost_.clear();
    for (const auto& lost : places_.lost()) lost_.push_back({lost.first, lost.second, lost.value});
    // A contact of the next step finds here its place in this one, from 1; a new one finds 0.
    std::iota(places_.values().begin(), places_.values().end(), std::uint64_t{1});
  }

  /// Copies the values of kept contacts; runs of contacts that stay together at once.
  void carry(const std::byte* from, std::byte* to) const {
    const std::size_t count = before_.size();
    for (std::size_t first = 0; first < count;) {
      std::size_t last = first + 1;
      if (before_[first] == 0) {
        first = last;
        continue;
      }
      while (last < count && before_[last] == before_[last - 1] + 1) ++last;
      std::memcpy(to + first * value_bytes_, from + (before_[first] - 1) * value_bytes_,
                  (last - first) * value_bytes_);
      first = last;
    }
  }

  /// A contact that is no more: ids of its elements, and its place in the last step, from 1.
  struct Lost {
    std::uint64_t first;
    std::uint64_t second;
    std::uint64_t place;
  };

  [[nodiscard]] const ContactHistory<std::uint64_t>& places() const noexcept { return places_; }
  [[nodiscard]] const std::vector<Lost>& lost() const noexcept { return lost_; }
  [[nodiscard]] std::size_t value_bytes() const noexcept { return value_bytes_; }
  [[nodiscard]] std::size_t size() const noexcept { return before_.size(); }
  [[nodiscard]] std::size_t size_before() const noexcept {
    const std::uint64_t most = before_.empty() ? 0 : *std::ranges::max_element(before_);
    return static_cast<std::size_t>(most);
  }

 private:
  std::size_t value_bytes_;
  ContactHistory<std::uint64_t> places_;
  std::vector<std::uint64_t> before_;  ///< place in the last step of each contact, from 1; or 0
  std::vector<Lost> lost_;
};

void update(ByteHistory& history, const PairResults& pairs, const Elements& elements,
            const Domain& domain, nb::handle ids) {
  if (ids.is_none()) return history.update(pairs, elements, domain, {});
  const NumberBuffer buffer(ids);
  history.update(pairs, elements, domain, whole_numbers_of<std::uint64_t>(buffer));
}

/// A table of bytes with a row for each value.
using ByteTable = nb::ndarray<std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using ReadByteTable = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

void carry(const ByteHistory& history, const ReadByteTable& from, const ByteTable& to) {
  const std::size_t width = history.value_bytes();
  if (from.shape(1) != width || to.shape(1) != width || to.shape(0) != history.size() ||
      from.shape(0) < history.size_before()) {
    throw nb::value_error("arrays of values do not fit the contacts");
  }
  history.carry(reinterpret_cast<const std::byte*>(from.data()),
                reinterpret_cast<std::byte*>(to.data()));
}

template <class T>
nb::ndarray<nb::numpy, T> copy_of(std::span<const T> numbers) {
  return given_away(std::vector<T>(numbers.begin(), numbers.end()));
}

nb::tuple lost_columns(const ByteHistory& history) {
  std::array<std::vector<std::uint64_t>, 3> columns;
  for (const ByteHistory::Lost& lost : history.lost()) {
    columns[0].push_back(lost.first);
    columns[1].push_back(lost.second);
    columns[2].push_back(lost.place - 1);
  }
  return nb::make_tuple(given_away(std::move(columns[0])), given_away(std::move(columns[1])),
                        given_away(std::move(columns[2])));
}

}  // namespace

void bind_history(nb::module_& module) {
  nb::class_<ByteHistory>(module, "ByteHistory")
      .def(nb::init<std::size_t>(), nb::arg("value_bytes"))
      .def("update", &update, nb::arg("pairs"), nb::arg("elements"), nb::arg("domain"),
           nb::arg("ids").none())
      .def("carry", &carry, nb::arg("before"), nb::arg("after"))
      .def_prop_ro("kept", [](const ByteHistory& history) { return history.places().kept(); })
      .def("born", [](const ByteHistory& history) { return copy_of(history.places().born()); })
      .def("flipped",
           [](const ByteHistory& history) { return copy_of(history.places().flipped()); })
      .def("lost", &lost_columns);
}

}  // namespace abut::python
