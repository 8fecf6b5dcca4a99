#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"

#include <cstdint>

namespace abut::device {

/// A cell is 2^20 units wide: cell = q >> 20 of a position q in units.
inline constexpr int unit_bits = 20;
inline constexpr double units_of_cell = 0x1p20;

/// A level takes the elements of one class of radii: cells of their own reach.
inline constexpr std::uint32_t most_levels = 8;

/// One level: its cells, which are numbered in one space of keys after those of smaller elements.
///
///   key = first_key + x + pitch[0] (y + pitch[1] z)        pitch = cells along the axis + 1
///
/// The cell too many at the end of each row and layer is empty. So the neighbors of a cell have the
/// keys key + dx + pitch[0] (dy + pitch[1] dz), and none of them is a cell elsewhere.
template <int Dim>
struct SizeLevel {
  double radius_end;      ///< its radii are smaller; of the last level infinite
  double largest_radius;  ///< at most this, scaled
  double units_of_one;    ///< units in one scaled length
  double finer;           ///< cells of this level in one of the last, >= 1
  std::uint64_t cells[Dim];
  std::uint64_t pitch[Dim];
  std::uint64_t first_key;
  std::uint32_t first_slot;  ///< of its elements, when they are sorted
  std::uint32_t end_slot;
};

/// A stretch of an axis without a wide gap, from the lowest coordinate in it on.
struct Stretch {
  double start;              ///< scaled
  std::uint64_t first_cell;  ///< in cells of the last level, as they were when gaps were closed
};

/// An axis from `lower` on, or, where the domain is far wider than its elements need, stretches.
struct Axis {
  double lower;              ///< scaled
  const Stretch* stretches;  ///< null: one, without end
  std::uint32_t stretch_count;
};

/// The map from lengths to whole numbers (docs/derivations/whole_numbers.md). Lengths are scaled by
/// a power of two first, so that nothing below overflows.
template <int Dim>
struct Frame {
  double scale;
  double margin;  ///< scaled
  double cell;    ///< width of the cells of the last level, scaled
  Axis axes[Dim];
  std::uint32_t level_count;
  SizeLevel<Dim> levels[most_levels];  ///< smallest elements first
  std::uint64_t key_count;
};

/// Where something lies, in units of a level.
template <int Dim>
struct Position {
  std::int64_t units[Dim];
};

template <int Dim>
[[nodiscard]] ABUT_HD inline std::uint32_t level_of(const Frame<Dim>& frame,
                                                    double radius) noexcept {
  std::uint32_t level = 0;
  while (radius >= frame.levels[level].radius_end) ++level;
  return level;
}

/// The last stretch that begins at or before a coordinate, which lies in one.
[[nodiscard]] ABUT_HD inline Stretch stretch_of(const Axis& axis, double scaled) noexcept {
  std::uint32_t first = 0;
  std::uint32_t count = axis.stretch_count;
  while (count > 1) {
    const std::uint32_t half = count / 2;
    if (axis.stretches[first + half].start <= scaled) {
      first += half;
      count -= half;
    } else {
      count = half;
    }
  }
  return axis.stretches[first];
}

/// The first cell of a stretch in a level.
[[nodiscard]] ABUT_HD inline std::uint64_t first_cell_in_level(const Stretch& stretch,
                                                               double finer) noexcept {
  if (stretch.first_cell == 0) return 0;
  return static_cast<std::uint64_t>(static_cast<double>(stretch.first_cell) * finer) + 1;
}

/// floor((x - lower) units_of_one): no coordinate lies below `lower`, so that truncation is floor.
template <int Dim>
[[nodiscard]] ABUT_HD inline std::int64_t units_along(const Axis& axis, const SizeLevel<Dim>& level,
                                                      double scaled) noexcept {
  if (axis.stretches == nullptr) {
    return static_cast<std::int64_t>((scaled - axis.lower) * level.units_of_one);
  }
  const Stretch stretch = stretch_of(axis, scaled);
  const std::uint64_t first_cell = first_cell_in_level(stretch, level.finer);
  return static_cast<std::int64_t>(first_cell << unit_bits) +
         static_cast<std::int64_t>((scaled - stretch.start) * level.units_of_one);
}

template <int Dim>
[[nodiscard]] ABUT_HD inline Position<Dim> position_of(const Frame<Dim>& frame,
                                                       const SizeLevel<Dim>& level,
                                                       const exact::Sphere<Dim>& sphere) noexcept {
  Position<Dim> position{};
  for (int axis = 0; axis < Dim; ++axis) {
    position.units[axis] = units_along(frame.axes[axis], level, sphere.center[axis] * frame.scale);
  }
  return position;
}

/// The key of a cell, given cell by cell along the axes.
template <int Dim>
[[nodiscard]] ABUT_HD inline std::uint64_t key_of(const SizeLevel<Dim>& level,
                                                  const std::uint64_t (&cell)[Dim]) noexcept {
  std::uint64_t key = cell[Dim - 1];
  for (int axis = Dim - 2; axis >= 0; --axis) key = key * level.pitch[axis] + cell[axis];
  return level.first_key + key;
}

}  // namespace abut::device
