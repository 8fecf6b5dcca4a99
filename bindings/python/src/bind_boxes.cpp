#include "bind.hpp"
#include "call_options.hpp"
#include "connectivity.hpp"
#include "elements.hpp"
#include "walls_out.hpp"

#include <abut/box_contacts.hpp>
#include <abut/fit_boxes.hpp>

#include <nanobind/stl/shared_ptr.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace abut::python {

namespace {

std::shared_ptr<WallResults<BoxContact>> find(const Elements& spheres, const Elements& boxes,
                                              const Domain& domain, const CallOptions& options) {
  const Options of_call = options.of_call();
  return found<BoxContact>(
      [&] { return find_box_contacts(spheres.view(), boxes.view(), domain, of_call); });
}

nb::dict measure_contacts(const Elements& spheres, const Elements& boxes, const Domain& domain,
                          nb::handle records, nb::handle shifts, const CallOptions& options) {
  return measured<BoxContact>(spheres.view(), boxes.view(), domain, records, shifts, options);
}

/// The lower bounds, axis by axis, then the upper ones.
nb::tuple fitted(const Elements& vertices, nb::handle cells, double skin) {
  const HeldConnectivity connectivity(cells);
  FittedBoxes boxes = [&] {
    const nb::gil_scoped_release unlocked;
    return fit_boxes(vertices.view(), connectivity.view(), skin);
  }();
  nb::list columns;
  for (auto* bounds : {&boxes.lower, &boxes.upper}) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(boxes.dimensions); ++axis) {
      columns.append(given_away(std::move((*bounds)[axis])));
    }
  }
  return nb::tuple(columns);
}

}  // namespace

void bind_boxes(nb::module_& module) {
  bind_wall_results<BoxContact>(module, "BoxContactResults");
  module.def("find_box_contacts", &find, nb::arg("spheres"), nb::arg("boxes"), nb::arg("domain"),
             nb::arg("options"));
  module.def("measure_box_contacts", &measure_contacts, nb::arg("spheres"), nb::arg("boxes"),
             nb::arg("domain"), nb::arg("records"), nb::arg("shifts").none(), nb::arg("options"));
  module.def("fit_boxes", &fitted, nb::arg("vertices"), nb::arg("cells"), nb::arg("skin"));
}

}  // namespace abut::python
