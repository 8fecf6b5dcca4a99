#include "elements/reject_element.hpp"

#include "base/shortest_text.hpp"

#include <abut/error.hpp>

#include <cmath>
#include <string>

namespace abut::elements {
namespace {

[[noreturn]] void reject(std::size_t element, const char* field, double value, const char* rule) {
  throw Error(ErrorCode::invalid_input, "element " + std::to_string(element) + " has " + field +
                                            " = " + base::shortest_text(value) + "; " + rule);
}

}  // namespace

template <int Dim>
void reject_element(std::size_t number, const exact::Sphere<Dim>& sphere) {
  static constexpr const char* axis_name[] = {"x", "y", "z"};
  for (int axis = 0; axis < Dim; ++axis) {
    if (!std::isfinite(sphere.center[axis])) {
      reject(number, axis_name[axis], sphere.center[axis],
             "positions must be finite: correct or remove this element");
    }
  }
  reject(number, "radius", sphere.radius,
         "radii must be finite and not negative: correct or remove this element");
}

template <int Dim>
void reject_element(std::size_t number, const exact::Box<Dim>& box) {
  static constexpr const char* lower_name[] = {"xmin", "ymin", "zmin"};
  static constexpr const char* upper_name[] = {"xmax", "ymax", "zmax"};
  constexpr const char* rule = "corners must be finite: correct or remove this element";
  for (int axis = 0; axis < Dim; ++axis) {
    if (!std::isfinite(box.lower[axis])) reject(number, lower_name[axis], box.lower[axis], rule);
  }
  for (int axis = 0; axis < Dim; ++axis) {
    if (!std::isfinite(box.upper[axis])) reject(number, upper_name[axis], box.upper[axis], rule);
  }
  int axis = 0;
  while (box.lower[axis] <= box.upper[axis]) ++axis;
  reject(number, lower_name[axis], box.lower[axis],
         ("more than " + std::string(upper_name[axis]) + " = " +
          base::shortest_text(box.upper[axis]) + "; exchange them or correct this element")
             .c_str());
}

template void reject_element(std::size_t, const exact::Sphere<2>&);
template void reject_element(std::size_t, const exact::Sphere<3>&);
template void reject_element(std::size_t, const exact::Box<2>&);
template void reject_element(std::size_t, const exact::Box<3>&);

}  // namespace abut::elements
