#include "bind.hpp"

#include "array_out.hpp"
#include "call_options.hpp"
#include "elements.hpp"
#include "geometry_out.hpp"
#include "held_results.hpp"
#include "pair_arrays.hpp"
#include "statistics_out.hpp"

#include <abut/detect.hpp>
#include <abut/domain.hpp>
#include <abut/two_sets.hpp>

#include <nanobind/stl/string_view.h>

#include <nanobind/stl/shared_ptr.h>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <memory>

namespace abut::python {

namespace {

/// Finds the pairs while other threads of Python run.
std::shared_ptr<PairResults> find(const Elements& elements, const Elements* others,
                                  const Domain& domain, const CallOptions& options) {
  const Options of_call = options.of_call();
  PairList list;
  {
    const nb::gil_scoped_release unlocked;
    list = others != nullptr ? find_contact_pairs(elements.view(), others->view(), domain, of_call)
                             : find_contact_pairs(elements.view(), domain, of_call);
  }
  return std::make_shared<PairResults>(std::move(list));
}

nb::dict count(const Elements& elements, const Elements* others, const Domain& domain,
               const CallOptions& options) {
  const Options of_call = options.of_call();
  Statistics statistics;
  {
    const nb::gil_scoped_release unlocked;
    statistics = others != nullptr
                     ? count_contact_pairs(elements.view(), others->view(), domain, of_call)
                     : count_contact_pairs(elements.view(), domain, of_call);
  }
  return fields_of(statistics);
}

}  // namespace

nb::dict fields_of(const Statistics& statistics) {
  nb::dict fields;
  fields["algorithm"] = name_of(statistics.algorithm);
  fields["reason"] = statistics.reason;
  fields["threads"] = statistics.threads;
  fields["simd"] = name_of(statistics.simd);
  fields["elements"] = statistics.elements;
  fields["dimensions"] = statistics.dimensions;
  fields["contact_pairs"] = statistics.contact_pairs;
  fields["candidate_tests"] = statistics.candidate_tests;
  fields["exact_decisions"] = statistics.exact_decisions;
  fields["list_insertions"] = statistics.list_insertions;
  fields["peak_bytes"] = statistics.peak_bytes;
  fields["working_bytes"] = statistics.working_bytes;
  fields["gather_seconds"] = statistics.gather_seconds;
  fields["search_seconds"] = statistics.search_seconds;
  fields["order_seconds"] = statistics.order_seconds;
  fields["measure_seconds"] = statistics.measure_seconds;
  return fields;
}

void bind_pairs(nb::module_& module) {
  nb::class_<PairResults> type(module, "PairResults");
  type.def("__len__", [](const PairResults& results) { return results.list().size(); })
      .def_prop_ro("pairs",
                   [](nb::pointer_and_handle<PairResults> self) {
                     return table_of<std::uint32_t>(self.p->list().pairs(), self.h);
                   })
      .def_prop_ro("shifts",
                   [](nb::pointer_and_handle<PairResults> self) {
                     return table_of<std::int32_t>(self.p->list().shifts(), self.h);
                   })
      .def_prop_ro("statistics", [](const PairResults& results) {
        return fields_of(results.list().statistics());
      });
  bind_stored_geometry(type);
  module.def("find_contact_pairs", &find, nb::arg("elements"), nb::arg("others").none(),
             nb::arg("domain"), nb::arg("options"));
  module.def("count_contact_pairs", &count, nb::arg("elements"), nb::arg("others").none(),
             nb::arg("domain"), nb::arg("options"));
}

}  // namespace abut::python
