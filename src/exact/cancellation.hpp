#pragma once

#include "base/host_device.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <algorithm>
#include <cmath>

namespace abut::exact {

/// Cancellation of coordinates by lattice vectors beyond which a compensated sum is not enough: a
/// difference that is smaller than this, relative to its largest term, is summed exactly.
inline constexpr double most_cancellation = 0x1p-40;

/// The largest coordinate, and the largest component of a vector that moves b.
template <int Dim>
[[nodiscard]] ABUT_HD double largest_term(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                          const LatticeSteps<Dim>& steps) noexcept {
  double largest = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    largest = std::max(std::max(largest, std::fabs(a.center[axis])), std::fabs(b.center[axis]));
    for (const auto& step : steps) {
      largest = std::max(largest, std::fabs(step.number * step.vector[axis]));
    }
  }
  return largest;
}

}  // namespace abut::exact
