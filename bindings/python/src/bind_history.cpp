#include "bind.hpp"
#include "byte_history.hpp"
#include "elements.hpp"
#include "held_results.hpp"

#include <abut/contact_history.hpp>

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>

namespace abut::python {

namespace {

using PairHistory = ByteHistory<ContactHistory<std::uint64_t>>;

void make(PairHistory* history, std::size_t value_bytes, int threads) {
  Options options;
  options.threads = threads;
  new (history) PairHistory(value_bytes, ContactHistory<std::uint64_t>(options));
}

void update(PairHistory& history, const PairResults& pairs, const Elements& elements,
            const Domain& domain, nb::handle ids) {
  with_ids(ids, [&](std::span<const std::uint64_t> numbers) {
    history.update(pairs.list(), elements.view(), domain, numbers);
  });
}

}  // namespace

void bind_history(nb::module_& module) {
  bind_byte_history<ContactHistory<std::uint64_t>>(module, "PairHistory")
      .def("__init__", &make, nb::arg("value_bytes"), nb::arg("threads"))
      .def("update", &update, nb::arg("pairs"), nb::arg("elements"), nb::arg("domain"),
           nb::arg("ids").none())
      .def("flipped",
           [](const PairHistory& history) { return copy_of(history.places().flipped()); })
      .def("lost", [](const PairHistory& history) {
        return nb::make_tuple(of_lost(history, [](const auto& lost) { return lost.first; }),
                              of_lost(history, [](const auto& lost) { return lost.second; }));
      });
}

}  // namespace abut::python
