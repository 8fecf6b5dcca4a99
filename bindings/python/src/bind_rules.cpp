#include "bind.hpp"
#include "call_options.hpp"

#include <abut/error.hpp>
#include <abut/exclusion_list.hpp>
#include <abut/group_table.hpp>
#include <abut/pair_rule.hpp>

#include <nanobind/stl/optional.h>
#include <cstdint>
#include <utility>

#include <optional>
#include <span>

namespace abut::python {

namespace {

std::span<const ContactPair> pairs_of(const NumberBuffer& buffer) {
  const std::span<const std::uint32_t> numbers = whole_numbers_of<std::uint32_t>(buffer);
  return {reinterpret_cast<const ContactPair*>(numbers.data()), numbers.size() / 2};
}

ExclusionList exclusions_of(nb::handle pairs, std::size_t elements,
                            std::optional<std::size_t> others) {
  const NumberBuffer buffer(pairs);
  if (others) return ExclusionList(pairs_of(buffer), elements, *others);
  return ExclusionList(pairs_of(buffer), elements);
}

template <class T>
std::span<const T> kept(HeldRule& held, nb::handle array) {
  if (array.is_none()) return {};
  return whole_numbers_of<T>(held.buffers.emplace_back(array));
}

PairTraits traits_of(HeldRule& held, const nb::tuple& arrays) {
  return {kept<std::uint32_t>(held, arrays[0]), kept<std::uint64_t>(held, arrays[1]),
          kept<std::uint64_t>(held, arrays[2])};
}

HeldRule rule_of(const nb::tuple& elements, const nb::tuple& others, nb::object table,
                 nb::object exclusions) {
  HeldRule held;
  held.rule.elements = traits_of(held, elements);
  held.rule.others = traits_of(held, others);
  if (!table.is_none()) held.rule.table = nb::cast<const GroupTable*>(table);
  if (!exclusions.is_none()) held.rule.exclusions = nb::cast<const ExclusionList*>(exclusions);
  held.tables = {std::move(table), std::move(exclusions)};
  return held;
}

void bind_group_table(nb::module_& module) {
  nb::class_<GroupTable>(module, "GroupTable",
                         "Table of the groups of elements that may pair: symmetric, at first all "
                         "may pair.")
      .def(nb::init<std::uint32_t>(), nb::arg("groups"),
           "Makes a table for groups 0 to groups - 1, at most 32768.")
      .def("__len__", &GroupTable::size)
      .def("allow", &GroupTable::allow, nb::arg("a"), nb::arg("b"), nb::rv_policy::reference,
           "Allows pairs of groups a and b, in both orders. Returns the table.")
      .def("deny", &GroupTable::deny, nb::arg("a"), nb::arg("b"), nb::rv_policy::reference,
           "Denies pairs of groups a and b, in both orders. Returns the table.")
      .def("deny_all", &GroupTable::deny_all, nb::rv_policy::reference,
           "Denies all pairs; a start for tables that allow few. Returns the table.")
      .def(
          "allows",
          [](const GroupTable& table, std::uint32_t a, std::uint32_t b) {
            if (a >= table.size() || b >= table.size()) {
              throw nb::index_error("the table has no such group");
            }
            return table.allows(a, b);
          },
          nb::arg("a"), nb::arg("b"), "True if elements of these groups may pair.");
}

}  // namespace

void bind_rules(nb::module_& module) {
  bind_group_table(module);
  nb::class_<ExclusionList>(module, "Exclusions")
      .def("__len__", &ExclusionList::size)
      .def_prop_ro("is_of_two_sets", &ExclusionList::is_of_two_sets)
      .def(
          "contains",
          [](const ExclusionList& list, ElementIndex i, ElementIndex j) {
            return list.contains({i, j});
          },
          nb::arg("i"), nb::arg("j"));
  module.def("exclusions", &exclusions_of, nb::arg("pairs"), nb::arg("elements"),
             nb::arg("others").none());
  nb::class_<HeldRule>(module, "Rule");
  module.def("rule", &rule_of, nb::arg("elements"), nb::arg("others"), nb::arg("table").none(),
             nb::arg("exclusions").none());
}

}  // namespace abut::python
