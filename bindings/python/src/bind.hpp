#pragma once

#include <nanobind/nanobind.h>

namespace abut::python {

namespace nb = nanobind;

/// One function for each part of the module; module.cpp calls them in an order in which types are
/// known before they are used.
void bind_errors(nb::module_& module);
void bind_facts(nb::module_& module);
void bind_domain(nb::module_& module);
void bind_elements(nb::module_& module);
void bind_rules(nb::module_& module);
void bind_options(nb::module_& module);
void bind_pairs(nb::module_& module);
void bind_measure(nb::module_& module);
void bind_pair_graph(nb::module_& module);
void bind_neighbors(nb::module_& module);
void bind_spatial_order(nb::module_& module);
void bind_boxes(nb::module_& module);
void bind_mesh(nb::module_& module);
void bind_simplices(nb::module_& module);
void bind_detector(nb::module_& module);
void bind_history(nb::module_& module);
void bind_wall_history(nb::module_& module);
void bind_files(nb::module_& module);

}  // namespace abut::python
