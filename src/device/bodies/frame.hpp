#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"

#include <cstdint>

namespace abut::device {

/// A cell is 2^20 units wide: cell = q >> 20 of a position q in units.
inline constexpr int unit_bits = 20;
inline constexpr double units_of_cell = 0x1p20;

/// The most levels that elements are divided into.
inline constexpr std::uint32_t most_levels = 8;

/// An axis from `lower` on, or, where that is far longer than its elements need, in stretches
/// without a wide gap.
struct Axis {
  double lower;                      ///< scaled
  std::uint32_t stretch_count;       ///< 0: one, without end
  const std::uint32_t* first_slots;  ///< of each stretch the slot of its lowest element

  [[nodiscard]] ABUT_HD bool is_divided() const noexcept { return stretch_count > 0; }
};

/// The elements of one class of radii, in cells of their own reach from their own lowest corner on.
/// The cells of all levels are numbered in one space of keys:
///
///   key = first_key + x + pitch[0] (y + pitch[1] z)        pitch = cells along the axis + 1
///
/// The cell too many at the end of each row and layer is empty. So the neighbors of a cell have the
/// keys key + dx + pitch[0] (dy + pitch[1] dz), and none of them is a cell elsewhere.
template <int Dim>
struct SizeLevel {
  double radius_end;      ///< its radii are smaller; of the last level infinite
  double largest_radius;  ///< of its elements, scaled
  double largest_reach;   ///< of two of them, scaled
  double units_of_one;    ///< units in one scaled length
  double widest_gap;      ///< along its axes, scaled, where these are divided
  Axis axes[Dim];
  std::uint64_t cells[Dim];
  std::uint64_t pitch[Dim];
  std::uint64_t first_key;
  std::uint32_t first_slot;  ///< of its elements, when they are sorted
  std::uint32_t end_slot;
};

/// The map from lengths to whole numbers (docs/derivations/whole_numbers.md). Lengths are scaled by
/// a power of two first, so that nothing below overflows.
template <int Dim>
struct Frame {
  double scale;
  double margin;  ///< scaled
  double slack;   ///< of distances, scaled: positions of periodic images are rounded
  std::uint32_t level_count;
  SizeLevel<Dim> levels[most_levels];  ///< smallest elements first
  std::uint64_t key_count;
};

/// The number of the level that takes a radius.
template <int Dim>
[[nodiscard]] ABUT_HD inline std::uint32_t level_of(const Frame<Dim>& frame,
                                                    double radius) noexcept {
  std::uint32_t level = 0;
  while (radius >= frame.levels[level].radius_end) ++level;
  return level;
}

/// Where an element of the level lies along an axis in one piece, in units:
/// floor((x - lower) units_of_one). No element lies below the lower end, so that truncation is
/// floor.
[[nodiscard]] ABUT_HD inline std::uint64_t units_along(const Axis& axis, double units_of_one,
                                                       double scaled) noexcept {
  return static_cast<std::uint64_t>((scaled - axis.lower) * units_of_one);
}

/// The key of a cell, given by its numbers along the axes.
template <int Dim>
[[nodiscard]] ABUT_HD inline std::uint64_t key_of(const SizeLevel<Dim>& level,
                                                  const std::uint64_t (&cell)[Dim]) noexcept {
  std::uint64_t key = cell[Dim - 1];
  for (int axis = Dim - 2; axis >= 0; --axis) key = key * level.pitch[axis] + cell[axis];
  return level.first_key + key;
}

}  // namespace abut::device
