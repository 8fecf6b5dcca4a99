#pragma once

#include "base/host_device.hpp"
#include "device/bodies/filter_verdict.hpp"
#include "exact/box.hpp"
#include "exact/periodic_box.hpp"
#include "exact/sphere_predicate.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

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

/// Half of the width of the band of boxes, in units, with which whole numbers alone are compared:
/// section 9.
inline constexpr std::int32_t box_slack = 4;

/// By how much one of two boxes begins behind the end of the other at most, over all axes, in
/// units.
struct FarthestEnds {
  std::int32_t excess = std::numeric_limits<std::int32_t>::min();

  ABUT_HD void include(std::int32_t behind) noexcept { excess = excess < behind ? behind : excess; }

  [[nodiscard]] ABUT_HD FilterVerdict verdict(std::int32_t margin) const noexcept {
    const std::int32_t beyond = excess - margin;
    if (beyond > box_slack) return FilterVerdict::apart;
    return beyond < -box_slack ? FilterVerdict::within : FilterVerdict::doubtful;
  }
};

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

/// Compares boxes in double precision whose ends are off by `slack` at most. What two operations
/// round is covered by nearly four times as much; where sums overflow nothing is decided.
template <int Dim>
[[nodiscard]] ABUT_HD inline FilterVerdict filter(const exact::Box<Dim>& a,
                                                  const exact::Box<Dim>& b, double margin,
                                                  double slack) noexcept {
  FilterVerdict verdict = FilterVerdict::within;
  for (int axis = 0; axis < Dim; ++axis) {
    const double lower[] = {a.lower[axis], b.lower[axis]};
    const double upper[] = {b.upper[axis], a.upper[axis]};
    for (int side = 0; side < 2; ++side) {
      const double excess = (lower[side] - upper[side]) - margin;
      const double magnitude = std::fabs(lower[side]) + std::fabs(upper[side]) + margin;
      const double tolerance = slack + exact::box_band * magnitude;
      if (excess > tolerance) return FilterVerdict::apart;
      if (!(excess < -tolerance)) verdict = FilterVerdict::doubtful;
    }
  }
  return verdict;
}

}  // namespace abut::device
