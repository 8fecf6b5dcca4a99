#include "engine/tiles/tile_cells.hpp"

#include "kernels/search_job.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::engine {
namespace {

/// Rows, at most, for each element, beside those of a small tile: each has its padding, and in a
/// tile that is thin along the rows, as many as there are cells.
constexpr double most_rows_per_element = 1.0 / kernels::row_padding;
constexpr double rows_of_small_tile = 512.0;

/// Positions are known to 2^-23 of a tile; a cell is to be known to 2^-10 of itself.
constexpr double most_cells_per_axis = 1 << 10;

template <int Dim>
double product(const std::array<double, Dim>& counts) {
  double result = 1.0;
  for (const double count : counts) result *= count;
  return result;
}

template <int Dim>
double rows_of(const std::array<double, Dim>& counts) {
  return product<Dim>(counts) / counts[0];
}

}  // namespace

template <int Dim>
TileCells<Dim> choose_tile_cells(const TileGrid<Dim>& grid, double unit, std::size_t element_count,
                                 double cells_per_element) {
  TileCells<Dim> cells;
  std::array<double, Dim> finest{};
  std::array<double, Dim> count{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    finest[axis] = std::max(1.0, std::floor(grid.size[axis] / grid.cell_size));
    count[axis] = std::min(finest[axis], most_cells_per_axis);
  }
  const auto elements = static_cast<double>(element_count);
  const double most_cells = cells_per_element * elements + 8.0;
  const double most_rows = most_rows_per_element * elements + rows_of_small_tile;
  for (double scale = 1.0; product<Dim>(count) > most_cells || rows_of<Dim>(count) > most_rows;
       scale *= 0.9375) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      count[axis] = std::clamp(std::floor(std::min(finest[axis], most_cells_per_axis) * scale), 1.0,
                               most_cells_per_axis);
    }
  }
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    cells.coarse = cells.coarse || count[axis] < finest[axis];
    cells.count[axis] = static_cast<std::int32_t>(count[axis]);
    // Rounded up, so that the upper face of the tile is not in its last cell.
    cells.per_unit[axis] =
        std::nextafter(static_cast<float>(count[axis] / (grid.size[axis] * unit)),
                       std::numeric_limits<float>::max());
  }
  return cells;
}

template TileCells<2> choose_tile_cells(const TileGrid<2>&, double, std::size_t, double);
template TileCells<3> choose_tile_cells(const TileGrid<3>&, double, std::size_t, double);

}  // namespace abut::engine
