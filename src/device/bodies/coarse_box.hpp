#pragma once

#include "base/host_device.hpp"
#include "device/bodies/cell_box.hpp"
#include "device/bodies/coarse_sphere.hpp"
#include "device/bodies/filter.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/sizes.hpp"
#include "exact/box.hpp"

#include <cmath>
#include <cstdint>

namespace abut::device {

/// Whole numbers compare boxes up to this width, in units, the margin and the widest element of the
/// level included.
inline constexpr double widest_box = 0x1p29;

/// A box of a larger class as a level of smaller ones sees it.
template <int Dim>
struct CoarseBox {
  std::uint32_t number;
  CellBox<Dim> cells;
  std::uint32_t lower[Dim];  ///< its ends as records have positions
  std::uint32_t upper[Dim];
  std::int32_t margin;  ///< in units, rounded down
  bool in_double;       ///< whether the filter is that of doubles

  /// `cells` are left to who knows them.
  [[nodiscard]] ABUT_HD static CoarseBox of(const exact::Box<Dim>& box, std::uint32_t number,
                                            const CoarseScales& scales,
                                            const SizeLevel<Dim>& level) noexcept {
    CoarseBox coarse{};
    coarse.number = number;
    const double beyond = scales.scaled_margin + 2.0 * level.largest_radius;
    for (int axis = 0; axis < Dim; ++axis) {
      const double ends[] = {box.lower[axis] * scales.scale, box.upper[axis] * scales.scale};
      coarse.in_double = coarse.in_double || level.axes[axis].is_divided();
      const double low = (ends[0] - level.axes[axis].lower) * level.units_of_one;
      const double high = (ends[1] - level.axes[axis].lower) * level.units_of_one;
      const bool is_near = std::fabs(low) <= farthest_center && std::fabs(high) <= farthest_center;
      const bool is_narrow = (high - low) + beyond * level.units_of_one <= widest_box;
      coarse.in_double = coarse.in_double || !is_near || !is_narrow;
      if (coarse.in_double) continue;
      coarse.lower[axis] = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(low)));
      coarse.upper[axis] = static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(high)));
    }
    if (!coarse.in_double) {
      coarse.margin = static_cast<std::int32_t>(scales.scaled_margin * level.units_of_one);
    }
    return coarse;
  }

  [[nodiscard]] ABUT_HD static CoordinateEnds<Dim> ends_of(const exact::Box<Dim>& box,
                                                           const CoarseScales& scales,
                                                           const SizeLevel<Dim>& level) noexcept {
    const double beyond = scales.scaled_margin + 2.0 * level.largest_radius;
    const double before = (beyond + scales.scaled_slack) * (1.0 + 0x1p-40);
    const double behind = (scales.scaled_margin + scales.scaled_slack) * (1.0 + 0x1p-40);
    CoordinateEnds<Dim> ends{};
    for (int axis = 0; axis < Dim; ++axis) {
      ends.lower[axis] = box.lower[axis] * scales.scale - before;
      ends.upper[axis] = box.upper[axis] * scales.scale + behind;
    }
    return ends;
  }

  [[nodiscard]] ABUT_HD FilterVerdict compare(const std::uint32_t* other,
                                              PackedWidths widths) const noexcept {
    FarthestEnds ends;
    for (int axis = 0; axis < Dim; ++axis) {
      ends.include(static_cast<std::int32_t>(lower[axis] - other[axis]) - widths.along(axis));
      ends.include(static_cast<std::int32_t>(other[axis] - upper[axis]));
    }
    return ends.verdict(margin);
  }
};

}  // namespace abut::device
