#pragma once

#include "exact/box.hpp"
#include "exact/sphere.hpp"

#include <cmath>
#include <limits>

namespace abut::elements {

/// Tells whether all numbers of a sphere are finite and its radius is not negative.
template <int Dim>
[[nodiscard]] bool is_valid(const exact::Sphere<Dim>& sphere) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  bool finite = sphere.radius >= 0.0 && sphere.radius <= largest;
  for (const double x : sphere.center) finite = finite && std::fabs(x) <= largest;
  return finite;
}

/// Tells whether all corners of a box are finite and none is below the other.
template <int Dim>
[[nodiscard]] bool is_valid(const exact::Box<Dim>& box) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  bool result = true;
  for (int axis = 0; axis < Dim; ++axis) {
    result = result && std::fabs(box.lower[axis]) <= largest &&
             std::fabs(box.upper[axis]) <= largest && box.lower[axis] <= box.upper[axis];
  }
  return result;
}

}  // namespace abut::elements
