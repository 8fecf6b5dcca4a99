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

/// Cells along an axis from the coordinate `start` on, in [first, end) of all cells of the axis.
struct StretchCells {
  double start;
  std::uint64_t first;
  std::uint64_t end;
  std::uint64_t all;

  /// By the sequence of units_along: each rounding keeps the order of coordinates, so that elements
  /// at or above this one are in this cell or a later one, and those at or below in this or an
  /// earlier one. Beyond the range it is the last cell there, empty where a gap follows.
  [[nodiscard]] ABUT_HD AxisCell at(double scaled, double units_of_one) const noexcept {
    const double units = (scaled - start) * units_of_one;
    if (!(units >= 0.0)) return {0, true, false};
    if (units < static_cast<double>(end - first) * units_of_cell) {
      return {first + (static_cast<std::uint64_t>(units) >> unit_bits), false, false};
    }
    return {end - 1, false, end == all};
  }
};

/// Scaled coordinates between which a coarse element may have partners.
template <int Dim>
struct CoordinateEnds {
  double lower[Dim];
  double upper[Dim];
};

/// The cells that these lie in, of a level whose axes are in one piece.
template <int Dim>
[[nodiscard]] ABUT_HD inline CellBox<Dim> cells_between(const SizeLevel<Dim>& level,
                                                        const CoordinateEnds<Dim>& ends) noexcept {
  CellBox<Dim> box{};
  for (int axis = 0; axis < Dim; ++axis) {
    const StretchCells all{level.axes[axis].lower, 0, level.cells[axis], level.cells[axis]};
    const AxisCell first = all.at(ends.lower[axis], level.units_of_one);
    const AxisCell last = all.at(ends.upper[axis], level.units_of_one);
    box.first[axis] = first.cell;
    box.last[axis] = last.cell;
    box.is_empty = box.is_empty || first.is_behind || last.is_before;
  }
  return box;
}

}  // namespace abut::device
