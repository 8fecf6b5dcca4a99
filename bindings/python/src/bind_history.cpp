#include "array_out.hpp"
#include "bind.hpp"
#include "byte_history.hpp"
#include "elements.hpp"
#include "held_results.hpp"

#include <abut/contact_history.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

using Lost = detail::ContactMatcher::Lost;

/// Values of any size for the contact pairs of each step: bytes that the caller gives a meaning.
class PairHistory {
 public:
  PairHistory(std::size_t value_bytes, int threads)
      : matcher_(options_of(threads)), fresh_(value_bytes) {}

  /// Takes the pairs of a step. The caller has the values of the last step carried to an array with
  /// a place for each pair.
  void update(const PairResults& pairs, const Elements& elements, const Domain& domain,
              nb::handle ids) {
    with_ids(ids, [&](std::span<const std::uint64_t> numbers) {
      matcher_.match(pairs.list(), elements.view(), domain, numbers);
    });
    matcher_.accept();
    size_before_ = std::exchange(size_, pairs.list().size());
  }

  /// Copies the values of kept contacts; new ones get zeros.
  void carry(const ValueTable& from, const NewValueTable& to) {
    require_tables(from, to, {fresh_.size(), size_before_, size_});
    matcher_.copy_values(bytes_of(from), {reinterpret_cast<std::byte*>(to.data()), fresh_.size(),
                                          fresh_.data(), size_});
  }

  [[nodiscard]] PairCount kept() const noexcept { return size_ - matcher_.born().size(); }
  [[nodiscard]] std::span<const PairCount> born() const noexcept { return matcher_.born(); }
  [[nodiscard]] std::span<const PairCount> flipped() const noexcept { return matcher_.flipped(); }

  /// An array with a number of each lost contact.
  [[nodiscard]] nb::ndarray<nb::numpy, std::uint64_t> of_lost(std::uint64_t Lost::*number) const {
    std::vector<std::uint64_t> numbers;
    for (const Lost& lost : matcher_.lost()) numbers.push_back(lost.*number);
    return given_away(std::move(numbers));
  }

 private:
  static Options options_of(int threads) {
    Options options;
    options.threads = threads;
    return options;
  }

  detail::ContactMatcher matcher_;
  std::vector<std::byte> fresh_;  ///< the value of a new contact
  PairCount size_ = 0;
  PairCount size_before_ = 0;
};

}  // namespace

void bind_history(nb::module_& module) {
  nb::class_<PairHistory>(module, "PairHistory")
      .def(nb::init<std::size_t, int>(), nb::arg("value_bytes"), nb::arg("threads"))
      .def("update", &PairHistory::update, nb::arg("pairs"), nb::arg("elements"), nb::arg("domain"),
           nb::arg("ids").none())
      .def("carry", &PairHistory::carry, nb::arg("before"), nb::arg("after"))
      .def_prop_ro("kept", &PairHistory::kept)
      .def("born", [](const PairHistory& history) { return copy_of(history.born()); })
      .def("flipped", [](const PairHistory& history) { return copy_of(history.flipped()); })
      .def("lost_places", [](const PairHistory& history) { return history.of_lost(&Lost::before); })
      .def("lost", [](const PairHistory& history) {
        return nb::make_tuple(history.of_lost(&Lost::first), history.of_lost(&Lost::second));
      });
}

}  // namespace abut::python
