#pragma once

#include "exact/numbers/cube_root.hpp"
#include "grid/bounds.hpp"

#include <cstddef>

namespace abut::engine {

/// Cells along all axes of a box; an axis shorter than a cell counts as one.
template <int Dim>
struct BoxInCells {
  BoxInCells(const grid::Bounds<Dim>& box, double cell) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double along = (box.upper[axis] - box.lower[axis]) / cell;
      if (along <= 1.0) continue;
      cells *= along;
      ++long_axes;
    }
  }

  double cells = 1.0;
  int long_axes = 0;
};

/// Returns the size of cells: `least`, or as much more as the box needs to have no more than so
/// many. Results follow from cells: roots have the same bits everywhere.
template <int Dim>
[[nodiscard]] double cell_for(const grid::Bounds<Dim>& box, double least, double cells) {
  double cell = least;
  // Axes may become shorter than a cell.
  for (int round = 0; round < Dim; ++round) {
    const BoxInCells<Dim> in_cells(box, cell);
    if (!(in_cells.cells > cells)) break;
    cell *= exact::side_of(in_cells.cells / cells, in_cells.long_axes);
  }
  return cell;
}

}  // namespace abut::engine
