#pragma once

#include "base/host_device.hpp"
#include "device/bodies/filter_verdict.hpp"
#include "exact/sphere_predicate.hpp"

#include <cstdint>

namespace abut::device {

/// Half of the width of the band, in units: whole numbers and single precision are off by less
/// than 3.2 between two elements of one level (docs/derivations/whole_numbers.md, section 3).
inline constexpr float filter_slack = 4.0F;
/// Beyond a cell it grows with the reach: section 4.
inline constexpr float slack_of_reach = 0x1p-20F;

/// Compares two positions less than 2^31 units apart on each axis; `reach` and `slack` in units.
template <int Dim>
[[nodiscard]] ABUT_HD inline FilterVerdict filter(const std::uint32_t* a, const std::uint32_t* b,
                                                  float reach, float slack) noexcept {
  float distance_squared = 0.0F;
  for (int axis = 0; axis < Dim; ++axis) {
    const auto difference = static_cast<float>(static_cast<std::int32_t>(a[axis] - b[axis]));
    distance_squared += difference * difference;
  }
  const float farthest = reach + slack;
  if (!(distance_squared <= farthest * farthest)) return FilterVerdict::apart;
  const float nearest = reach - slack;
  if (nearest > 0.0F && distance_squared < nearest * nearest) return FilterVerdict::within;
  return FilterVerdict::doubtful;
}

/// Hands a candidate to a sink unless it is apart.
template <class Spheres, class Sink>
ABUT_HD inline void take_if_near(const Spheres& elements, std::uint32_t one, std::uint32_t other,
                                 FilterVerdict verdict, Sink& sink) noexcept {
  if (verdict == FilterVerdict::apart) return;
  const FilterVerdict counted = elements.counted(one, other, verdict);
  if (counted != FilterVerdict::apart) sink.take(one, other, counted);
}

/// Compares positions in double precision whose distance is off by `slack` at most: without one the
/// filter of exact::within_reach, of which docs/derivations/predicate_band.md is the proof.
template <int Dim>
[[nodiscard]] ABUT_HD inline FilterVerdict filter(const exact::Sphere<Dim>& a,
                                                  const exact::Sphere<Dim>& b, double margin,
                                                  double slack) noexcept {
  double difference = a.center[0] - b.center[0];
  double distance_squared = difference * difference;
  for (int axis = 1; axis < Dim; ++axis) {
    difference = a.center[axis] - b.center[axis];
    distance_squared += difference * difference;
  }
  const double reach = a.radius + b.radius + margin;
  const double farthest = reach + slack;
  const double farthest_squared = farthest * farthest;
  if (!(farthest_squared >= exact::smallest_safe_square &&
        farthest_squared <= exact::largest_safe_square)) {
    return FilterVerdict::doubtful;
  }
  if (distance_squared > farthest_squared * (1.0 + exact::band)) return FilterVerdict::apart;
  const double nearest = reach - slack;
  const double nearest_squared = nearest * nearest;
  if (nearest > 0.0 && nearest_squared >= exact::smallest_safe_square &&
      distance_squared < nearest_squared * (1.0 - exact::band)) {
    return FilterVerdict::within;
  }
  return FilterVerdict::doubtful;
}

}  // namespace abut::device
