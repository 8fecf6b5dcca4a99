#include "bind.hpp"

NB_MODULE(_abut, module) {
  using namespace abut::python;
  module.doc() = "The compiled part of the package abut; use the package.";
  // What modules of a caller hold until the interpreter ends is no leak.
  nanobind::set_leak_warnings(false);
  bind_errors(module);
  bind_facts(module);
  bind_domain(module);
  bind_elements(module);
  bind_rules(module);
  bind_options(module);
  bind_pairs(module);
  bind_measure(module);
  bind_pair_graph(module);
  bind_neighbors(module);
  bind_spatial_order(module);
  bind_boxes(module);
  bind_mesh(module);
  bind_simplices(module);
  bind_detector(module);
  bind_history(module);
  bind_wall_history(module);
  bind_files(module);
}
