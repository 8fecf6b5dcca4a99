#pragma once

#include "base/host_device.hpp"
#include "device/bodies/place.hpp"
#include "exact/sphere_predicate.hpp"

#include <cstdint>

namespace abut::device {

/// What a filter says of a candidate: only `doubtful` ones are decided exactly.
enum class FilterVerdict : std::uint8_t { apart, doubtful, within };

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

/// Compares the caller's numbers in double precision: the filter of exact::within_reach, of which
/// docs/derivations/predicate_band.md is the proof.
template <int Dim>
[[nodiscard]] ABUT_HD inline FilterVerdict filter(const exact::Sphere<Dim>& a,
                                                  const exact::Sphere<Dim>& b,
                                                  double margin) noexcept {
  double difference = a.center[0] - b.center[0];
  double distance_squared = difference * difference;
  for (int axis = 1; axis < Dim; ++axis) {
    difference = a.center[axis] - b.center[axis];
    distance_squared += difference * difference;
  }
  const double reach = a.radius + b.radius + margin;
  const double reach_squared = reach * reach;
  if (reach_squared >= exact::smallest_safe_square && reach_squared <= exact::largest_safe_square) {
    if (distance_squared > reach_squared * (1.0 + exact::band)) return FilterVerdict::apart;
    if (distance_squared < reach_squared * (1.0 - exact::band)) return FilterVerdict::within;
  }
  return FilterVerdict::doubtful;
}

}  // namespace abut::device
