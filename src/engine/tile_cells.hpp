#pragma once

#include "engine/tile_grid.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The division of a tile into cells.
template <int Dim>
struct TileCells {
  std::array<std::int32_t, Dim> count{};  ///< own cells along each axis
  std::array<float, Dim> per_unit{};      ///< of the tile's coordinates
  bool coarse = false;                    ///< larger than the reach asks for

  /// Volume of one cell, in cubes (squares) of side `unit_length`.
  [[nodiscard]] double volume_in(const TileGrid<Dim>& grid, double unit_length) const noexcept {
    double result = 1.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result *= grid.size[axis] / unit_length / count[axis];
    }
    return result;
  }

  /// Sides of a cell in the tile's unit.
  [[nodiscard]] std::array<double, Dim> size_in_unit(const TileGrid<Dim>& grid,
                                                     double unit) const noexcept {
    std::array<double, Dim> result{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result[axis] = grid.size[axis] * unit / count[axis];
    }
    return result;
  }
};

/// Chooses cells that are as small as the reach allows, but not many more than there are elements.
template <int Dim>
[[nodiscard]] TileCells<Dim> choose_tile_cells(const TileGrid<Dim>& grid, double unit,
                                               std::size_t element_count);

}  // namespace abut::engine
