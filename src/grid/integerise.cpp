// From positions to cells.
//
// THE MARGIN. Let d be the largest exact reach, c the cell size, u = 2^-53. For an element at x in
// a segment that starts at o <= x, Q = (x - o) / c exactly, and the computed
// q = fl(fl(x - o) * fl(1 / c)) has |q - Q| <= 3.01 u Q. Two elements within reach have
// |Q_i - Q_j| <= d / c on every axis. To fall two cells apart, q_i and q_j must differ by more
// than 1, hence Q_i and Q_j by more than 1 - 6.02 u Q. With Q <= 2^31 that is 1 - 2^-19.4, so
//   c >= d (1 + 2^-19)
// excludes it, with room for the rounding of d and c themselves (a few u) and for coordinates that
// the scaling pushes below the normal range (2^-1075 against a cell of at least 2^-900).
// Munjiza's c = d, by contrast, misses touching pairs.

#include "grid/integerise.hpp"

#include "base/asking_sort.hpp"
#include "grid/axis_map.hpp"
#include "grid/scaling.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace abut::grid {
namespace {

constexpr double cell_margin = 1.0 + 0x1p-19;
constexpr double most_cells_in_one_segment = 0x1p30;
constexpr double last_cell = 0x1p31 - 3;  // guards and counts stay within 31 bits

/// Scale of positions whose numbers are too large (grid/scaling.hpp). Here 2^-64 is enough, where
/// nothing is squared.
constexpr double scale_of_large = 0x1p-64;
constexpr double smallest_cell_size = 0x1p-900;

/// The least number of cells along each axis that makes one cell per element.
template <int Dim>
double cells_a_side(std::size_t element_count) {
  const auto elements = static_cast<double>(element_count);
  double side = 1.0;
  while ((Dim == 2 ? side * side : side * side * side) < elements) side += 1.0;
  return side;
}

/// Side of a cell, in scaled units. Points without reach pair only when they coincide, so that any
/// cell will do: about one element in each.
template <int Dim>
double choose_cell_size(const Bounds<Dim>& bounds, double margin, double scale,
                        std::size_t element_count) {
  const double reach =
      bounds.largest_radius * scale + bounds.second_largest_radius * scale + margin * scale;
  if (reach > 0.0) return std::max(reach * cell_margin, smallest_cell_size);
  double extent = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    extent = std::max(extent, bounds.upper[axis] * scale - bounds.lower[axis] * scale);
  }
  return std::max(extent / cells_a_side<Dim>(element_count), smallest_cell_size);
}

double cell_of(const Segment& segment, double scaled, double cell_size) {
  return segment.first_cell + std::floor((scaled - segment.start) * (1.0 / cell_size));
}

void require_cell_fits(double cell) {
  if (cell <= last_cell) return;
  throw Error(ErrorCode::limit_exceeded,
              "the elements occupy more than 2147483646 cells along one axis; split the system");
}

/// One segment a cluster: coordinates sorted, split where the gap exceeds a cell.
template <int Dim>
base::Array<Segment> collapse_gaps(std::span<const exact::Sphere<Dim>> spheres, std::size_t axis,
                                   double scale, double cell_size,
                                   base::DetectionContext& context) {
  auto sorted = base::make_array_for_overwrite<double>(context.memory, spheres.size());
  for (std::size_t k = 0; k < spheres.size(); ++k) sorted[k] = spheres[k].center[axis] * scale;
  context.work.did(spheres.size());
  base::sort_asking(sorted.begin(), sorted.end(), context.work);

  auto segments = base::make_array_for_overwrite<Segment>(context.memory, 0);
  segments.push_back({sorted.front(), 0});
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    context.work.did(1);
    if (sorted[k] - sorted[k - 1] <= cell_size) continue;
    const Segment& last = segments.back();
    // One empty cell between: clusters never look adjacent.
    const double first_cell = cell_of(last, sorted[k - 1], cell_size) + 2.0;
    require_cell_fits(first_cell);
    segments.push_back({sorted[k], static_cast<std::int32_t>(first_cell)});
  }
  require_cell_fits(cell_of(segments.back(), sorted.back(), cell_size));
  return segments;
}

template <int Dim, class MapOf>
std::array<AxisMap, Dim> maps_of_axes(MapOf map_of) {
  if constexpr (Dim == 2) {
    return {map_of(0), map_of(1)};
  } else {
    return {map_of(0), map_of(1), map_of(2)};
  }
}

/// Axis after axis, in blocks that stay in the nearest cache.
template <int Dim>
void map_all(std::span<const exact::Sphere<Dim>> spheres, const std::array<AxisMap, Dim>& maps,
             CellCoordinates<Dim>& cells, base::WorkCounter& work) {
  constexpr std::size_t block_size = 512;
  for (std::size_t begin = 0; begin < spheres.size(); begin += block_size) {
    const std::size_t end = std::min(begin + block_size, spheres.size());
    work.did(end - begin);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const AxisMap& map = maps[axis];
      std::int32_t* const cell = cells.axis(axis).data();
      for (std::size_t k = begin; k < end; ++k) cell[k] = map.cell(spheres[k].center[axis]);
    }
  }
}

}  // namespace

template <int Dim>
CellCoordinates<Dim> integerise(std::span<const exact::Sphere<Dim>> spheres,
                                const Bounds<Dim>& bounds, double margin,
                                base::DetectionContext& context) {
  CellCoordinates<Dim> cells(spheres.size(), context.memory);
  if (spheres.empty()) return cells;

  const double scale = largest_number(bounds, margin) > largest_unscaled ? scale_of_large : 1.0;
  const double cell_size = choose_cell_size(bounds, margin, scale, spheres.size());

  const auto map_of = [&](std::size_t axis) {
    const double start = bounds.lower[axis] * scale;
    const double extent_in_cells = (bounds.upper[axis] * scale - start) * (1.0 / cell_size);
    const bool one_segment = extent_in_cells <= most_cells_in_one_segment;
    auto segments = one_segment ? base::make_array<Segment>(context.memory, 1, Segment{start, 0})
                                : collapse_gaps(spheres, axis, scale, cell_size, context);
    AxisMap map(scale, cell_size, std::move(segments));
    cells.cell_count[axis] = map.cell(bounds.upper[axis]) + 1;
    cells.uncollapsed_cell_count[axis] = std::floor(extent_in_cells) + 1.0;
    return map;
  };
  map_all<Dim>(spheres, maps_of_axes<Dim>(map_of), cells, context.work);
  return cells;
}

template CellCoordinates<2> integerise(std::span<const exact::Sphere<2>>, const Bounds<2>&, double,
                                       base::DetectionContext&);
template CellCoordinates<3> integerise(std::span<const exact::Sphere<3>>, const Bounds<3>&, double,
                                       base::DetectionContext&);

}  // namespace abut::grid
