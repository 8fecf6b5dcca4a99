#pragma once

#include "base/host_device.hpp"
#include "device/bodies/cell_box.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/frame.hpp"
#include "exact/sphere.hpp"

#include <cmath>
#include <cstdint>

namespace abut::device {

/// Whole numbers compare larger elements with those of a level up to this size, in units, and no
/// farther from the corner than the second; the others are compared in double.
inline constexpr double widest_ball = 0x1p30;
inline constexpr double farthest_center = 0x1p51;

/// Margin and slack, scaled as the cells are and as the elements are given.
struct CoarseScales {
  double scale;
  double scaled_margin;
  double scaled_slack;
  double margin;
  double slack;
};

/// A larger element as a level of smaller ones sees it.
template <int Dim>
struct CoarseSphere {
  std::uint32_t number;
  CellBox<Dim> cells;
  std::uint32_t units[Dim];  ///< its position as records have it
  float own_reach;           ///< its radius and the margin, in units
  float slack;               ///< in units
  bool in_double;            ///< whether the filter is that of doubles

  /// `cells` are left to who knows them.
  [[nodiscard]] ABUT_HD static CoarseSphere of(const exact::Sphere<Dim>& sphere,
                                               std::uint32_t number, const CoarseScales& scales,
                                               const SizeLevel<Dim>& level) noexcept {
    CoarseSphere coarse{};
    coarse.number = number;
    const double own = sphere.radius * scales.scale + scales.scaled_margin;
    const double farthest = own + level.largest_radius;
    coarse.own_reach = static_cast<float>(own * level.units_of_one);
    coarse.slack =
        filter_slack + slack_of_reach * static_cast<float>(farthest * level.units_of_one);
    coarse.in_double = !(farthest * level.units_of_one <= widest_ball);
    for (int axis = 0; axis < Dim; ++axis) {
      const double center = sphere.center[axis] * scales.scale;
      const double units = (center - level.axes[axis].lower) * level.units_of_one;
      coarse.in_double = coarse.in_double || level.axes[axis].is_divided() ||
                         !(std::fabs(units) <= farthest_center);
      if (coarse.in_double) continue;
      coarse.units[axis] = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(units)));
    }
    return coarse;
  }

  [[nodiscard]] ABUT_HD static CoordinateEnds<Dim> ends_of(const exact::Sphere<Dim>& sphere,
                                                           const CoarseScales& scales,
                                                           const SizeLevel<Dim>& level) noexcept {
    const double own = sphere.radius * scales.scale + scales.scaled_margin;
    const double farthest = own + level.largest_radius;
    const double distance = (farthest + scales.scaled_slack) * (1.0 + 0x1p-40);
    CoordinateEnds<Dim> ends{};
    for (int axis = 0; axis < Dim; ++axis) {
      const double center = sphere.center[axis] * scales.scale;
      ends.lower[axis] = center - distance;
      ends.upper[axis] = center + distance;
    }
    return ends;
  }

  [[nodiscard]] ABUT_HD FilterVerdict compare(const std::uint32_t* other,
                                              float radius) const noexcept {
    return filter<Dim>(units, other, own_reach + radius, slack);
  }
};

}  // namespace abut::device
