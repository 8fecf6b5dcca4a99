#pragma once

#include "base/host_device.hpp"
#include "device/bodies/filter.hpp"

#include <abut/element_view.hpp>

#include <cstdint>
#include <type_traits>

namespace abut::device {

/// The widths of a box along the axes in units of its level, rounded down: fewer than 2^20 each,
/// since a cell is no narrower than the reach.
struct PackedWidths {
  static constexpr int bits = 21;

  std::uint64_t packed;

  ABUT_HD void set(int axis, std::uint64_t width) noexcept { packed |= width << (axis * bits); }

  [[nodiscard]] ABUT_HD std::int32_t along(int axis) const noexcept {
    return static_cast<std::int32_t>(packed >> (axis * bits) & ((std::uint64_t{1} << bits) - 1));
  }
};

/// What is kept of the size of an element.
template <class Spheres>
using SizeOf = std::conditional_t<Spheres::shape == Shape::box, PackedWidths, float>;

/// The sizes of sorted spheres, in units of their level: one radius each, or one reach for all.
template <int Dim>
struct SphereSizes {
  const float* radii;  ///< null: all pairs have the common reach
  float common_reach;
  float margin;

  [[nodiscard]] ABUT_HD float reach(std::uint32_t a, std::uint32_t b) const noexcept {
    return radii == nullptr ? common_reach : radii[a] + radii[b] + margin;
  }

  /// Compares the elements of two slots by their positions.
  [[nodiscard]] ABUT_HD FilterVerdict compare(const std::uint32_t* units_a, std::uint32_t a,
                                              const std::uint32_t* units_b,
                                              std::uint32_t b) const noexcept {
    return filter<Dim>(units_a, units_b, reach(a, b), filter_slack);
  }
};

/// Those of sorted boxes.
template <int Dim>
struct BoxSizes {
  const PackedWidths* widths;
  std::int32_t margin;  ///< rounded down

  [[nodiscard]] ABUT_HD FilterVerdict compare(const std::uint32_t* units_a, std::uint32_t a,
                                              const std::uint32_t* units_b,
                                              std::uint32_t b) const noexcept {
    const PackedWidths width_a = widths[a];
    const PackedWidths width_b = widths[b];
    FarthestEnds ends;
    for (int axis = 0; axis < Dim; ++axis) {
      const auto ahead = static_cast<std::int32_t>(units_b[axis] - units_a[axis]);
      ends.include(ahead - width_a.along(axis));
      ends.include(-ahead - width_b.along(axis));
    }
    return ends.verdict(margin);
  }
};

template <class Spheres>
using SizesOf = std::conditional_t<Spheres::shape == Shape::box, BoxSizes<Spheres::dimensions>,
                                   SphereSizes<Spheres::dimensions>>;

}  // namespace abut::device
