#include "bind.hpp"

#include "array_out.hpp"
#include "call_options.hpp"
#include "elements.hpp"
#include "geometry_out.hpp"
#include "held_results.hpp"
#include "statistics_out.hpp"

#include <abut/neighbor_list.hpp>
#include <abut/two_sets.hpp>

#include <nanobind/stl/shared_ptr.h>
#include <cstdint>
#include <utility>

#include <memory>

namespace abut::python {

namespace {

NeighborListKind kind_of(bool full) {
  return full ? NeighborListKind::full : NeighborListKind::half;
}

std::shared_ptr<NeighborResults> built(const Elements& elements, const Elements* others,
                                       const Domain& domain, bool full,
                                       const CallOptions& options) {
  const Options of_call = options.of_call();
  NeighborList list;
  {
    const nb::gil_scoped_release unlocked;
    list = others != nullptr ? build_neighbor_list(elements.view(), others->view(), domain, of_call)
                             : build_neighbor_list(elements.view(), domain, kind_of(full), of_call);
  }
  return std::make_shared<NeighborResults>(std::move(list));
}

std::shared_ptr<NeighborResults> within(const Elements& points, double cutoff, const Domain& domain,
                                        bool full, const CallOptions& options) {
  const Options of_call = options.of_call();
  NeighborList list;
  {
    const nb::gil_scoped_release unlocked;
    list = neighbors(points.view(), cutoff, domain, kind_of(full), of_call);
  }
  return std::make_shared<NeighborResults>(std::move(list));
}

using Self = nb::pointer_and_handle<NeighborResults>;

}  // namespace

void bind_neighbors(nb::module_& module) {
  nb::class_<NeighborResults> type(module, "NeighborResults");
  type.def("__len__", [](const NeighborResults& results) { return results.list().size(); })
      .def_prop_ro("offsets", [](Self self) { return array_of(self.p->list().offsets(), self.h); })
      .def_prop_ro("neighbors",
                   [](Self self) { return array_of(self.p->list().neighbors(), self.h); })
      .def_prop_ro(
          "shifts",
          [](Self self) { return table_of<std::int32_t>(self.p->list().shifts(), self.h); })
      .def_prop_ro("statistics", [](const NeighborResults& results) {
        return fields_of(results.list().statistics());
      });
  bind_stored_geometry(type);
  module.def("build_neighbor_list", &built, nb::arg("elements"), nb::arg("others").none(),
             nb::arg("domain"), nb::arg("full"), nb::arg("options"));
  module.def("neighbors", &within, nb::arg("points"), nb::arg("cutoff"), nb::arg("domain"),
             nb::arg("full"), nb::arg("options"));
}

}  // namespace abut::python
