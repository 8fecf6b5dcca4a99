#pragma once

#include "grid/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace abut::grid {

/// Systems whose largest number is above this are mapped to cells at a smaller scale: sums,
/// differences and reciprocals of larger numbers could leave the range of exponents.
inline constexpr double largest_unscaled = 0x1p960;

/// Factor of that smaller scale. What the scaling rounds away is far below the smallest cell.
inline constexpr double scale_down = 0x1p-128;

/// Returns the largest absolute value of a position, a radius or the margin of a detection.
template <int Dim>
[[nodiscard]] double largest_number(const Bounds<Dim>& bounds, double margin) noexcept {
  double largest = std::max(bounds.largest_radius, margin);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    if (bounds.lower[axis] > bounds.upper[axis]) continue;  // no element
    largest = std::max({largest, std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis])});
  }
  return largest;
}

}  // namespace abut::grid
