#pragma once

#include "exact/elements.hpp"
#include "grid/bounds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace abut::engine {

/// Bounds of the centers of locals that a coarse element may reach: a box and, if the coarse
/// element is a sphere, a ball in it. None of the roundings here leaves out a local element: a
/// local element's center is a double, so that what is >= a real bound is >= the bound rounded.
template <int Dim>
struct QueryBox {
  std::array<double, Dim> lower{};
  std::array<double, Dim> upper{};
  std::array<double, Dim> center{};
  double inverse_radius = 0.0;  ///< of the ball; 0: all of the box

  /// Locals with radii up to `largest_radius`.
  static QueryBox of(const exact::Elements<Dim>& elements, std::size_t coarse,
                     double largest_radius, double margin) noexcept {
    const exact::Sphere<Dim>& sphere = elements[coarse];
    QueryBox result;
    std::copy_n(sphere.center, Dim, result.center.begin());
    if (elements.are_boxes()) {
      const double before = enlarged(2.0 * largest_radius + margin);
      const double behind = enlarged(margin);
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        result.lower[axis] = elements.boxes[coarse].lower[axis] - before;
        result.upper[axis] = elements.boxes[coarse].upper[axis] + behind;
      }
      return result;
    }
    const double reach = enlarged(sphere.radius + largest_radius + margin);
    result.inverse_radius = 1.0 / reach;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result.lower[axis] = sphere.center[axis] - reach;
      result.upper[axis] = sphere.center[axis] + reach;
    }
    return result;
  }

  /// True if the box holds the center of a sphere.
  [[nodiscard]] bool holds(const exact::Sphere<Dim>& sphere) const noexcept {
    bool result = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result = result && lower[axis] <= sphere.center[axis] && upper[axis] >= sphere.center[axis];
    }
    return result;
  }

  /// True if a local element in that box may be within reach.
  [[nodiscard]] bool meets(const grid::Bounds<Dim>& box) const noexcept {
    bool result = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result = result && lower[axis] <= box.upper[axis] && upper[axis] >= box.lower[axis];
    }
    return result;
  }

 private:
  /// Roundings of the reach, and of what is compared with it, where it is far larger than a tile.
  static constexpr double relative_slack = 0x1p-40;
  /// Below the width of any tile; its inverse is finite.
  static constexpr double smallest_reach = 0x1p-940;

  static double enlarged(double rounded_reach) noexcept {
    return std::max(rounded_reach * (1.0 + relative_slack), smallest_reach);
  }
};

}  // namespace abut::engine
