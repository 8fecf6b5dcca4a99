#include "engine/tiles/tile_grid.hpp"

#include <algorithm>
#include <cmath>

namespace abut::engine {
namespace {

/// Rounding of a position in units of tiles, generously.
constexpr double place_slack = 0x1p-30;

/// A tile of elements that all lie in a plane still has a width.
constexpr double least_width_in_cells = 0x1p-30;

/// Limits by which positions in tiles are known to 2^-31 and numbers of tiles, those of the frame
/// included, fit into 26 bits.
constexpr double most_tiles_along_axis = 0x1p20;
constexpr double most_tiles_with_frame = 0x1p26 - 1.0;

template <class Bounds>
auto extent_of(const Bounds& box) {
  auto extent = box.upper;
  for (std::size_t axis = 0; axis < extent.size(); ++axis) extent[axis] -= box.lower[axis];
  return extent;
}

/// True if tiles of that side over the box are within the limits.
template <int Dim>
bool few_enough(const std::array<double, Dim>& extent, double side, double most_tiles) {
  double tiles = 1.0;
  double with_frame = 1.0;
  bool short_rows = true;
  for (const double length : extent) {
    const double along_axis = std::max(1.0, std::floor(length / side));
    tiles *= along_axis;
    with_frame *= along_axis + 2.0;
    short_rows = short_rows && along_axis <= most_tiles_along_axis;
  }
  return tiles <= most_tiles && with_frame <= most_tiles_with_frame && short_rows;
}

/// Side of at most `most_tiles` equal tiles. An axis shorter than that side has one tile, and the
/// others share what is left. Only products and quotients: the same tiles on every machine.
template <int Dim>
double side_of_tiles(const std::array<double, Dim>& extent, double smallest, double most_tiles) {
  double side = smallest;
  while (!few_enough<Dim>(extent, 2.0 * side, most_tiles)) side *= 2.0;
  while (!few_enough<Dim>(extent, side, most_tiles)) side *= 1.0625;
  return side;
}

}  // namespace

template <int Dim>
TileGrid<Dim> TileGrid<Dim>::over(const grid::Bounds<Dim>& box, double cell_size,
                                  double least_cells, double most_tiles) {
  std::array<double, Dim> tiles{};
  tiles.fill(1.0);
  if (most_tiles < 2.0) return of_counts(box, cell_size, tiles);
  const std::array<double, Dim> extent = extent_of(box);
  const double side = side_of_tiles<Dim>(extent, least_cells * cell_size, most_tiles);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    tiles[axis] = std::max(1.0, std::floor(extent[axis] / side));
  }
  return of_counts(box, cell_size, tiles);
}

template <int Dim>
TileGrid<Dim> TileGrid<Dim>::slices_of(const grid::Bounds<Dim>& box, double cell_size,
                                       double slices) {
  const std::array<double, Dim> extent = extent_of(box);
  std::array<double, Dim> tiles{};
  tiles.fill(1.0);
  const auto longest = std::max_element(extent.begin(), extent.end()) - extent.begin();
  tiles[static_cast<std::size_t>(longest)] = slices;
  return of_counts(box, cell_size, tiles);
}

/// The grid of so many tiles along each axis.
template <int Dim>
TileGrid<Dim> TileGrid<Dim>::of_counts(const grid::Bounds<Dim>& box, double cell_size,
                                       const std::array<double, Dim>& tiles) {
  TileGrid grid;
  grid.cell_size = cell_size;
  grid.lower = box.lower;
  const std::array<double, Dim> extent = extent_of(box);
  std::int32_t stride = 1;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    grid.count[axis] = static_cast<std::int32_t>(tiles[axis]);
    grid.size[axis] = std::max(extent[axis] / tiles[axis], cell_size * least_width_in_cells);
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
