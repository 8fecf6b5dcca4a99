#pragma once

#include "grid/bounds.hpp"
#include "kernels/element_kernels.hpp"

#include <algorithm>
#include <cstddef>

namespace abut::grid {

/// Has `kernel(ElementBounds&)` widen the bounds; returns what it does, how many elements it
/// treated.
template <int Dim, class Kernel>
std::size_t widen(Bounds<Dim>& bounds, Kernel&& kernel) {
  kernels::ElementBounds packed{};
  std::copy(bounds.lower.begin(), bounds.lower.end(), packed.lower);
  std::copy(bounds.upper.begin(), bounds.upper.end(), packed.upper);
  packed.smallest_radius = bounds.smallest_radius;
  packed.largest_radius = bounds.largest_radius;
  packed.second_largest_radius = bounds.second_largest_radius;
  const std::size_t treated = kernel(packed);
  std::copy_n(packed.lower, Dim, bounds.lower.begin());
  std::copy_n(packed.upper, Dim, bounds.upper.begin());
  bounds.smallest_radius = packed.smallest_radius;
  bounds.largest_radius = packed.largest_radius;
  bounds.second_largest_radius = packed.second_largest_radius;
  return treated;
}

}  // namespace abut::grid
