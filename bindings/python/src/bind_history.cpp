#include "bind.hpp"
#include "byte_history.hpp"
#include "elements.hpp"
#include "held_results.hpp"

#include <abut/contact_history.hpp>

#include <cstdint>
#include <span>

namespace abut::python {

namespace {

using PairHistory = ByteHistory<ContactHistory<std::uint64_t>>;

void update(PairHistory& history, const PairResults& pairs, const Elements& elements,
            const Domain& domain, nb::handle ids) {
  with_ids(ids, [&](std::span<const std::uint64_t> numbers) {
    history.update(pairs.list(), elements.view(), domain, numbers);
  });
}

}  // namespace

void bind_history(nb::module_& module) {
  bind_byte_history<ContactHistory<std::uint64_t>>(module, "PairHistory")
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
