#pragma once

#include "kernels/searched_elements.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// The elements of a tile sorted by cell. Along each axis the tile's own cells are framed by one
/// layer of copies of the elements around it; each row ends with padding:
///
///   index   0        1 .. k    k + 1    k + 2
///   holds   copies   own       copies   row_padding places, far away on the first axis
///
///   cell = (z * (k_y + 2) + y) * (k_x + 3) + x     (in 2D z = 0 only, without a frame)
///
/// A cell holds either own elements or copies, never both.
struct TileView : SearchedElements {
  const std::uint32_t* cell;        ///< of the element
  const std::uint32_t* cell_begin;  ///< first place of each cell; one more at the end
  std::int32_t cells[3];            ///< own cells k along each axis
  float per_unit[3];                ///< cells in a unit of the coordinates, on each axis

  [[nodiscard]] std::int32_t row_length() const noexcept { return cells[0] + 3; }
  [[nodiscard]] std::int32_t layer_length() const noexcept { return row_length() * (cells[1] + 2); }
};

/// Some layers of the cells of a tile, in 2D rows; those of copies are the first and the last.
struct Layers {
  std::int32_t begin;
  std::int32_t end;
};

[[nodiscard]] inline Layers all_layers(const TileView& tile, int dimensions) noexcept {
  return {0, tile.cells[dimensions - 1] + 2};
}

/// A row of cells, for the elements in it.
template <std::size_t Runs>
struct RowOfCells {
  const std::uint32_t* cell_begin;  ///< of its first cell, which holds copies
  std::uint32_t first_cell;
  std::ptrdiff_t step[Runs];  ///< from a cell to the one above it in the row of each run
  float index[3];             ///< of the row, in cells, on all axes but the first
};

/// Coordinates in cells are known to 2^-10, generously: an element nearer than that to being within
/// reach of a face of its cell is taken to be. The reach is that of the filter, with
/// SearchJob::slack: cells may be much smaller than that is (docs/derivations/tile_filter.md,
/// section 6).
inline constexpr float nearby_slack = 0x1p-9f;

}  // namespace abut::kernels
