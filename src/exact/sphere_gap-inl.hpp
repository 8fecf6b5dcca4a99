#pragma once

// The gap of two spheres, for both processors.

#include "base/host_device.hpp"
#include "exact/sphere_gap.hpp"
#include "exact/sphere_predicate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::exact {
namespace detail {

/// A power of two that brings a number, the larger of distance and sum of radii, near one where
/// squares would leave the exponent range; 1 elsewhere, so that ordinary numbers are not touched.
[[nodiscard]] ABUT_HD inline double scale_of_squares(double largest) noexcept {
  if (largest > 0x1p500) return 0x1p-600;
  if (largest < 0x1p-400 && largest > 0.0) return 0x1p600;
  return 1.0;
}

[[nodiscard]] ABUT_HD inline double made_finite(double value) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  return std::min(std::max(value, -largest), largest);
}

}  // namespace detail

/// distance - (r_a + r_b) as it is computed: only its sign may be wrong.
template <int Dim>
[[nodiscard]] ABUT_HD double computed_gap(const Sphere<Dim>& a, const Sphere<Dim>& b) noexcept {
  double largest = std::max(a.radius, b.radius);
  for (int axis = 0; axis < Dim; ++axis) {
    // Half of each: the difference itself may overflow.
    largest = std::max(largest, std::fabs(0.5 * a.center[axis] - 0.5 * b.center[axis]));
  }
  const double scale = detail::scale_of_squares(largest);
  double distance_squared = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double difference = scale == 0x1p-600 ? a.center[axis] * scale - b.center[axis] * scale
                                                : (a.center[axis] - b.center[axis]) * scale;
    distance_squared += difference * difference;
  }
  const double scaled = std::sqrt(distance_squared) - (a.radius * scale + b.radius * scale);
  return detail::made_finite(scaled / scale);
}

/// The gap of elements of which it is known whether they touch.
[[nodiscard]] ABUT_HD inline double gap_of_sign(double computed, bool touch) noexcept {
  if (touch) return std::min(computed, 0.0) + 0.0;  // never -0.0
  return std::max(computed, std::numeric_limits<double>::denorm_min());
}

template <int Dim>
ABUT_HD double gap(const Sphere<Dim>& a, const Sphere<Dim>& b) noexcept {
  std::uint64_t exact_decisions = 0;
  const bool touch = within_reach(a, b, 0.0, exact_decisions);
  return gap_of_sign(computed_gap(a, b), touch);
}

}  // namespace abut::exact
