#include "bind.hpp"

#include <abut/algorithm.hpp>
#include <abut/simd.hpp>
#include <abut/version.hpp>

#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>

namespace abut::python {

namespace {

nb::list facts_about_algorithms() {
  nb::list result;
  for (const AlgorithmInfo& info : algorithms()) {
    nb::dict facts;
    facts["name"] = info.name;
    facts["idea"] = info.idea;
    facts["time"] = info.time;
    facts["memory"] = info.memory;
    facts["book_pages"] = info.book_pages;
    facts["min_dimensions"] = info.min_dimensions;
    facts["max_dimensions"] = info.max_dimensions;
    facts["periodic"] = info.periodic;
    facts["traceable"] = info.traceable;
    result.append(facts);
  }
  return result;
}

nb::list names_of_levels() {
  nb::list result;
  for (const Simd level : simd_levels()) {
    if (available(level)) result.append(name_of(level));
  }
  return result;
}

}  // namespace

void bind_facts(nb::module_& module) {
  module.def("algorithms", &facts_about_algorithms);
  module.def("simd_levels", &names_of_levels);
  module.def("version", &version);
  module.def("build_description", &build_description);
}

}  // namespace abut::python
