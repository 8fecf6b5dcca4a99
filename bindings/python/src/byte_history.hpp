#pragma once

#include "array_out.hpp"
#include "number_buffer.hpp"

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>
#include <vector>

namespace abut::python {

namespace nb = nanobind;

/// Values as rows of bytes, one for each contact.
using NewValueTable = nb::ndarray<std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using ValueTable = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

[[nodiscard]] inline const std::byte* bytes_of(const ValueTable& table) {
  return reinterpret_cast<const std::byte*>(table.data());
}

/// The bytes of a value, and the contacts of two steps.
struct TableSizes {
  std::size_t value_bytes;
  std::size_t before;
  std::size_t now;
};

inline void require_tables(const ValueTable& from, const NewValueTable& to,
                           const TableSizes& sizes) {
  if (from.shape(1) != sizes.value_bytes || to.shape(1) != sizes.value_bytes ||
      to.shape(0) != sizes.now || from.shape(0) < sizes.before) {
    throw nb::value_error("arrays of values do not fit the contacts");
  }
}

/// Values of any size for the contacts of each step: bytes that the caller gives a meaning.
/// `Places` is a history of whole numbers, which are the places of contacts in the last step.
template <class Places>
class ByteHistory {
 public:
  explicit ByteHistory(std::size_t value_bytes) : value_bytes_(value_bytes) {}

  /// Takes the contacts of a step, as Places::update does. The caller has the values of kept
  /// contacts copied from the array of the last step to one with a value for each contact, zeros at
  /// first.
  template <class... Step>
  void update(const Step&... step) {
    places_.update(step...);
    before_.assign(places_.values().begin(), places_.values().end());
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

  /// The history of places. The values of its lost contacts are places in the last step, from 1.
  [[nodiscard]] const Places& places() const noexcept { return places_; }
  [[nodiscard]] std::size_t value_bytes() const noexcept { return value_bytes_; }
  [[nodiscard]] std::size_t size() const noexcept { return before_.size(); }
  [[nodiscard]] std::size_t size_before() const noexcept {
    const std::uint64_t most = before_.empty() ? 0 : *std::ranges::max_element(before_);
    return static_cast<std::size_t>(most);
  }

 private:
  std::size_t value_bytes_;
  Places places_;
  std::vector<std::uint64_t> before_;  ///< place in the last step of each contact, from 1; or 0
};

/// Calls a function with the ids of elements, which may be None.
template <class Function>
void with_ids(nb::handle ids, Function&& function) {
  if (ids.is_none()) return function(std::span<const std::uint64_t>());
  const NumberBuffer buffer(ids);
  function(whole_numbers_of<std::uint64_t>(buffer));
}

template <class T>
[[nodiscard]] nb::ndarray<nb::numpy, T> copy_of(std::span<const T> numbers) {
  return given_away(std::vector<T>(numbers.begin(), numbers.end()));
}

/// An array with a number of each lost contact.
template <class Places, class NumberOf>
[[nodiscard]] nb::ndarray<nb::numpy, std::uint64_t> of_lost(const ByteHistory<Places>& history,
                                                            NumberOf&& number_of) {
  std::vector<std::uint64_t> numbers;
  for (const auto& lost : history.places().lost()) numbers.push_back(number_of(lost));
  return given_away(std::move(numbers));
}

/// Binds what the histories of contacts with walls have in common.
template <class Places>
nb::class_<ByteHistory<Places>> bind_byte_history(nb::module_& module, const char* name) {
  using History = ByteHistory<Places>;
  nb::class_<History> type(module, name);
  type.def(nb::init<std::size_t>(), nb::arg("value_bytes"))
      .def(
          "carry",
          [](const History& history, const ValueTable& from, const NewValueTable& to) {
            require_tables(from, to,
                           {history.value_bytes(), history.size_before(), history.size()});
            history.carry(bytes_of(from), reinterpret_cast<std::byte*>(to.data()));
          },
          nb::arg("before"), nb::arg("after"))
      .def_prop_ro("kept", [](const History& history) { return history.places().kept(); })
      .def("born", [](const History& history) { return copy_of(history.places().born()); })
      .def("lost_places", [](const History& history) {
        return of_lost(history, [](const auto& lost) { return lost.value - 1; });
      });
  return type;
}

}  // namespace abut::python
