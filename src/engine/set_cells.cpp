#include "engine/set_cells.hpp"

#include <algorithm>
#include <array>

namespace abut::engine {
namespace {

/// Room for the roundings of single precision in a tile of at most 2^10 cells a side: see
/// docs/derivations/tile_filter.md.
constexpr double tile_cell_margin = 1.0 + 0x1p-10;

/// Cells below this size would make counts of cells, or their inverse, overflow.
constexpr double smallest_cell = 0x1p-900;
constexpr double most_cells_along_box = 0x1p60;

/// Tiles of so many cells a side have 15 % copies; wider ones fall out of the cache. Tiles of full
/// cells hold more elements: what their search needs at a time is two layers, while narrower ones
/// would have more copies (docs/adr/0010-rows-in-tiles.md).
constexpr double cells_along_tile = 18.0;
constexpr double elements_per_tile = 48000.0;
constexpr double least_elements_per_tile = 512.0;
constexpr double most_tiles = 1 << 25;

/// Tiles of so many elements, as far as there may be that many.
template <int Dim>
double tiles_of(const SearchSet<Dim>& set, double elements) {
  const double tiles = static_cast<double>(set.locals.size()) / elements;
  return std::clamp(tiles, set.least_tiles, std::max(set.least_tiles, most_tiles));
}

template <int Dim>
double fewest_tiles(const SearchSet<Dim>& set) {
  return tiles_of(set, elements_per_tile);
}

}  // namespace

template <int Dim>
double least_cell_for(const grid::Bounds<Dim>& bounds, const SearchInput<Dim>& input) {
  double cell = std::max(input.least_cell, smallest_cell);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    cell = std::max(cell, (bounds.upper[axis] - bounds.lower[axis]) / most_cells_along_box);
  }
  return cell;
}

template <int Dim>
double cell_size_for(const grid::Bounds<Dim>& bounds, const SearchInput<Dim>& input) {
  const double reach = bounds.largest_radius + bounds.second_largest_radius + input.margin;
  return std::max(reach * tile_cell_margin, least_cell_for(bounds, input));
}

template <int Dim>
double volume_in_cells(const grid::Bounds<Dim>& bounds, double cell) {
  constexpr double infinite = 0x1p300;
  double volume = 1.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    volume *= std::clamp((bounds.upper[axis] - bounds.lower[axis]) / cell, 1.0, infinite);
  }
  return volume;
}

template <int Dim>
double tile_volume_in_cells(const TileGrid<Dim>& grid) {
  grid::Bounds<Dim> tile;
  tile.lower.fill(0.0);
  tile.upper = grid.size;
  return volume_in_cells(tile, grid.cell_size);
}

template <int Dim>
TileGrid<Dim> cut_into_tiles(const SearchSet<Dim>& set, double cell) {
  const auto wide = TileGrid<Dim>::over(set.bounds, cell, cells_along_tile,
                                        tiles_of(set, least_elements_per_tile));
  return wide.tiles_in_box() >= fewest_tiles(set) ? wide : cut_into_few_tiles(set, cell);
}

template <int Dim>
TileGrid<Dim> cut_into_few_tiles(const SearchSet<Dim>& set, double cell) {
  return TileGrid<Dim>::over(set.bounds, cell, 1.0, fewest_tiles(set));
}

template double least_cell_for(const grid::Bounds<2>&, const SearchInput<2>&);
template double cell_size_for(const grid::Bounds<2>&, const SearchInput<2>&);
template double volume_in_cells(const grid::Bounds<2>&, double);
template double tile_volume_in_cells(const TileGrid<2>&);
template TileGrid<2> cut_into_tiles(const SearchSet<2>&, double);
template TileGrid<2> cut_into_few_tiles(const SearchSet<2>&, double);
template double least_cell_for(const grid::Bounds<3>&, const SearchInput<3>&);
template double cell_size_for(const grid::Bounds<3>&, const SearchInput<3>&);
template double volume_in_cells(const grid::Bounds<3>&, double);
template double tile_volume_in_cells(const TileGrid<3>&);
template TileGrid<3> cut_into_tiles(const SearchSet<3>&, double);
template TileGrid<3> cut_into_few_tiles(const SearchSet<3>&, double);

}  // namespace abut::engine
