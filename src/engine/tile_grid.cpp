#include "engine/tile_grid.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

/// Rounding of a position in units of tiles, generously.
constexpr double place_slack = 0x1p-30;

/// A tile of elements that all lie in a plane still has a width.
constexpr double least_width_in_cells = 0x1p-20;

/// Tiles over the box if they have at least that side.
template <int Dim>
double tiles_of_side(const std::array<double, Dim>& extent, double side) {
  double tiles = 1.0;
  for (const double length : extent) tiles *= std::max(1.0, std::floor(length / side));
  return tiles;
}

/// Side of at most `most_tiles` equal tiles. An axis shorter than that side has one tile, and the
/// others share what is left. Only products and quotients: the same tiles on every machine.
template <int Dim>
double side_of_tiles(const std::array<double, Dim>& extent, double smallest, double most_tiles) {
  double side = smallest;
  while (tiles_of_side<Dim>(extent, 2.0 * side) > most_tiles) side *= 2.0;
  while (tiles_of_side<Dim>(extent, side) > most_tiles) side *= 1.0625;
  return side;
}

}  // namespace

template <int Dim>
TileGrid<Dim> TileGrid<Dim>::over(const grid::Bounds<Dim>& box, double cell_size,
                                  double least_cells, double most_tiles) {
  TileGrid grid;
  grid.cell_size = cell_size;
  grid.lower = box.lower;
  std::array<double, Dim> extent{};
  for (std::size_t axis = 0; axis < Dim; ++axis) extent[axis] = box.upper[axis] - box.lower[axis];
  const double side = side_of_tiles<Dim>(extent, least_cells * cell_size, most_tiles);

  std::int32_t stride = 1;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double tiles = std::max(1.0, std::floor(extent[axis] / side));
    grid.count[axis] = static_cast<std::int32_t>(tiles);
    grid.size[axis] = std::max(extent[axis] / tiles, cell_size * least_width_in_cells);
    grid.inverse_size[axis] = 1.0 / grid.size[axis];
    grid.border[axis] = cell_size * grid.inverse_size[axis] + place_slack;
    grid.stride[axis] = stride;
    stride *= grid.count[axis] + 2;
  }
  grid.tile_count = static_cast<std::size_t>(stride);
  return grid;
}

template <int Dim>
kernels::PlaceMap TileGrid<Dim>::place_map() const noexcept {
  kernels::PlaceMap map{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    map.lower[axis] = lower[axis];
    map.inverse_size[axis] = inverse_size[axis];
    map.border[axis] = border[axis];
    map.last[axis] = count[axis] - 1;
    map.stride[axis] = stride[axis];
  }
  return map;
}

template struct TileGrid<2>;
template struct TileGrid<3>;

}  // namespace abut::engine
