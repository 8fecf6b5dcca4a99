#include "bind.hpp"

#include "array_out.hpp"
#include "call_options.hpp"
#include "elements.hpp"

#include <abut/spatial_order.hpp>

#include <utility>
#include <vector>

namespace abut::python {

namespace {

nb::ndarray<nb::numpy, ElementIndex> ordered(const Elements& elements, const CallOptions& options) {
  const Options of_call = options.of_call();
  std::vector<ElementIndex> order = [&] {
    const nb::gil_scoped_release unlocked;
    return spatial_order(elements.view(), of_call);
  }();
  return given_away(std::move(order));
}

}  // namespace

void bind_spatial_order(nb::module_& module) {
  module.def("spatial_order", &ordered, nb::arg("elements"), nb::arg("options"));
}

}  // namespace abut::python
