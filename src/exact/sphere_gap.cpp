#include "exact/sphere_gap.hpp"

#include "exact/sphere_predicate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::exact {
namespace {

/// A power of two that brings the larger of distance and sum of radii near one where squares would
/// leave the exponent range; 1 elsewhere, so that ordinary numbers are not touched.
template <int Dim>
double choose_scale(const Sphere<Dim>& a, const Sphere<Dim>& b) noexcept {
  double largest = std::max(a.radius, b.radius);
  for (int axis = 0; axis < Dim; ++axis) {
    // Half of each: the difference itself may overflow.
    largest = std::max(largest, std::fabs(0.5 * a.center[axis] - 0.5 * b.center[axis]));
  }
  if (largest > 0x1p500) return 0x1p-600;
  if (largest < 0x1p-400 && largest > 0.0) return 0x1p600;
  return 1.0;
}

}  // namespace

template <int Dim>
double gap(const Sphere<Dim>& a, const Sphere<Dim>& b) noexcept {
  const double scale = choose_scale(a, b);
  double distance_squared = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double difference = scale == 0x1p-600 ? a.center[axis] * scale - b.center[axis] * scale
                                                : (a.center[axis] - b.center[axis]) * scale;
    distance_squared += difference * difference;
  }
  const double scaled = std::sqrt(distance_squared) - (a.radius * scale + b.radius * scale);
  const double computed = std::clamp(scaled / scale, std::numeric_limits<double>::lowest(),
                                     std::numeric_limits<double>::max());

  std::uint64_t exact_decisions = 0;
  const bool touch = within_reach(a, b, 0.0, exact_decisions);
  if (touch) return std::min(computed, 0.0) + 0.0;  // never -0.0
  return std::max(computed, std::numeric_limits<double>::denorm_min());
}

template double gap(const Sphere<2>&, const Sphere<2>&) noexcept;
template double gap(const Sphere<3>&, const Sphere<3>&) noexcept;

}  // namespace abut::exact
