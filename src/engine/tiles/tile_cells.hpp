#pragma once

#include "engine/tiles/tile_grid.hpp"

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

/// Most cells for each element of a tile: with more, too many are empty. Where elements lie in
/// clusters, most cells are empty anyway.
inline constexpr double cells_of_even_tile = 1.0;
inline constexpr double cells_of_clustered_tile = 8.0;

/// Chooses cells that are as small as the reach allows, but not many more than `cells_per_element`
/// of them.
template <int Dim>
[[nodiscard]] TileCells<Dim> choose_tile_cells(const TileGrid<Dim>& grid, double unit,
                                               std::size_t element_count,
                                               double cells_per_element = cells_of_even_tile);

}  // namespace abut::engine
