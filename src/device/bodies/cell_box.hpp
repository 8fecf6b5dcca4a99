#pragma once

#include "base/host_device.hpp"
#include "device/bodies/frame.hpp"

#include <cstdint>

namespace abut::device {

/// The cells of a level in which a coarse element may have partners, by axis; rows are those along
/// the first.
template <int Dim>
struct CellBox {
  std::uint64_t first[Dim];
  std::uint64_t last[Dim];
  bool is_empty;

  [[nodiscard]] ABUT_HD std::uint64_t rows() const noexcept {
    if (is_empty) return 0;
    std::uint64_t rows = last[1] - first[1] + 1;
    if constexpr (Dim == 3) rows *= last[2] - first[2] + 1;
    return rows;
  }
};

/// A coordinate that need not be an element's, as a cell of an axis.
struct AxisCell {
  std::uint64_t cell;
  bool is_before;  ///< below the axis
  bool is_behind;  ///< above it
};

/// By the sequence of units_along: each rounding keeps the order of coordinates, so that elements
/// at or above this one are in this cell or a later one, and those at or below in this or an
/// earlier one. In a gap between stretches it is the empty cell there.
[[nodiscard]] ABUT_HD inline AxisCell cell_at(const Axis& axis, double units_of_one,
                                              std::uint64_t cells, double scaled) noexcept {
  Stretch stretch{axis.lower, 0};
  std::uint64_t end = cells;
  if (axis.stretches != nullptr) {
    const std::uint32_t number = stretch_of(axis, scaled);
    stretch = axis.stretches[number];
    if (number + 1 < axis.stretch_count) end = axis.stretches[number + 1].first_cell;
  }
  const double units = (scaled - stretch.start) * units_of_one;
  if (!(units >= 0.0)) return {0, true, false};
  const std::uint64_t room = end - stretch.first_cell;
  if (units < static_cast<double>(room) * units_of_cell) {
    return {stretch.first_cell + (static_cast<std::uint64_t>(units) >> unit_bits), false, false};
  }
  return {end - 1, false, end == cells};
}

/// The cells that scaled coordinates from `lower` to `upper` lie in.
template <int Dim>
[[nodiscard]] ABUT_HD inline CellBox<Dim> cells_between(const SizeLevel<Dim>& level,
                                                        const double (&lower)[Dim],
                                                        const double (&upper)[Dim]) noexcept {
  CellBox<Dim> box{};
  for (int axis = 0; axis < Dim; ++axis) {
    const auto cell_of = [&](double scaled) {
      return cell_at(level.axes[axis], level.units_of_one, level.cells[axis], scaled);
    };
    const AxisCell first = cell_of(lower[axis]);
    const AxisCell last = cell_of(upper[axis]);
    box.first[axis] = first.cell;
    box.last[axis] = last.cell;
    box.is_empty = box.is_empty || first.is_behind || last.is_before;
  }
  return box;
}

}  // namespace abut::device
