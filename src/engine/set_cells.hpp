#pragma once

#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
#include "engine/tiles/tile_grid.hpp"
#include "grid/bounds.hpp"

namespace abut::engine {

/// Returns the size of cells below which positions are not known well enough, or counts of cells
/// overflow.
template <int Dim>
[[nodiscard]] double least_cell_for(const grid::Bounds<Dim>& bounds, const SearchInput<Dim>& input);

/// Returns the size of cells for elements that may all meet: the reach with its margin, or the
/// least there may be.
template <int Dim>
[[nodiscard]] double cell_size_for(const grid::Bounds<Dim>& bounds, const SearchInput<Dim>& input);

/// Cells in a box; along each axis there is one at least.
template <int Dim>
[[nodiscard]] double volume_in_cells(const grid::Bounds<Dim>& bounds, double cell);

/// The same of a tile, in cells of the size of its grid's.
template <int Dim>
[[nodiscard]] double tile_volume_in_cells(const TileGrid<Dim>& grid);

/// Returns the tiles for a set: small ones where that costs no copies; else such as fit into the
/// cache.
template <int Dim>
[[nodiscard]] TileGrid<Dim> cut_into_tiles(const SearchSet<Dim>& set, double cell);

/// The same of as few as their elements allow.
template <int Dim>
[[nodiscard]] TileGrid<Dim> cut_into_few_tiles(const SearchSet<Dim>& set, double cell);

}  // namespace abut::engine
