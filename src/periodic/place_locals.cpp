#include "periodic/place_locals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::periodic {
namespace {

/// One element of wrap_fast.
template <int Dim>
lattice::CellsMoved wrap_fast(const kernels::CellSideMap& map, exact::Sphere<Dim>& sphere) {
  std::array<double, 3> cells{};
  for (std::size_t k = 0; k < map.sides; ++k) {
    if (!map.along[k]) continue;
    double place = kernels::coordinate<Dim>(map, k, sphere.center);
    for (std::size_t l = 0; l < k; ++l) place -= cells[l] * map.offset[l][k];
    cells[k] = std::floor(place);
  }
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    for (std::size_t k = 0; k < map.sides; ++k) {
      sphere.center[axis] -= cells[k] * map.vectors[k][axis];
    }
  }
  lattice::CellsMoved moved{};
  for (std::size_t k = 0; k < 3; ++k) moved[k] = static_cast<std::int32_t>(cells[k]);
  return moved;
}

}  // namespace

template <int Dim>
kernels::CellSideMap map_of(const lattice::CellSides<Dim>& cell) {
  kernels::CellSideMap map{};
  map.sides = cell.count;
  for (std::size_t k = 0; k < cell.count; ++k) {
    std::copy(cell.coefficients[k].begin(), cell.coefficients[k].end(), map.coefficients[k]);
    std::copy(cell.offset[k].begin(), cell.offset[k].end(), map.offset[k]);
  }
  return map;
}

template <int Dim>
kernels::CellSideMap map_of(const lattice::ReducedLattice<Dim>& lattice,
                            const lattice::CellSides<Dim>& cell, const std::array<bool, Dim>& along,
                            const GhostWindows<Dim>& windows) {
  kernels::CellSideMap map = map_of(cell);
  map.outer_from_radius = windows.cut;
  for (std::size_t k = 0; k < cell.count; ++k) {
    const auto& vector = lattice.vectors[cell.vector_of[k]];
    map.along[k] = along[k];
    map.outer_below[k] = windows.of_small.outer_below()[k];
    std::copy(vector.begin(), vector.end(), map.vectors[k]);
  }
  return map;
}

template <int Dim>
lattice::CellExtent<Dim> extent_of(const kernels::StridedSpheres& spheres, std::size_t first,
                                   std::size_t count, const lattice::CellSides<Dim>& cell,
                                   const grid::Bounds<Dim>& bounds,
                                   const kernels::ImageKernels& kernels) {
  kernels::CenterBounds sides{};
  std::fill_n(sides.lower, Dim, std::numeric_limits<double>::infinity());
  std::fill_n(sides.upper, Dim, -std::numeric_limits<double>::infinity());
  const std::size_t treated = kernels.bound_sides(spheres, first, count, Dim, map_of(cell), sides);
  const auto sphere_at = [&](std::size_t k) {
    return kernels::sphere_at<Dim>(spheres, first + treated + k);
  };
  lattice::CellExtent<Dim> extent = lattice::extent_of<Dim>(count - treated, sphere_at, cell);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    extent.lower[axis] = std::min(extent.lower[axis], sides.lower[axis]);
    extent.upper[axis] = std::max(extent.upper[axis], sides.upper[axis]);
    extent.farthest[axis] = std::max(std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis]));
  }
  return extent;
}

template <int Dim>
WrapEstimate<Dim>::WrapEstimate(const lattice::ReducedLattice<Dim>& lattice,
                                const lattice::OrthogonalCell<Dim>& orthogonal_cell,
                                const lattice::CellExtent<Dim>& given,
                                const std::array<bool, Dim>& along)
    : extent(given) {
  constexpr double longest = 0x1p24;  // in sides
  constexpr double rounding = 0x1p-20;
  most_cells = lattice::most_cells_moved<Dim>(orthogonal_cell, given, along);
  for (std::size_t k = 0; k < orthogonal_cell.count; ++k) {
    const auto& vector = lattice.vectors[orthogonal_cell.vector_of[k]];
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      extent.farthest[axis] += most_cells[k] * std::fabs(vector[axis]);
    }
    double distance = orthogonal_cell.magnitude(k, given.farthest);
    for (std::size_t l = 0; l < orthogonal_cell.count; ++l) {
      distance += orthogonal_cell.dual_length[k] *
                  (lattice.length[orthogonal_cell.vector_of[l]] * lattice.scale) * most_cells[l];
    }
    is_short = is_short && distance <= longest;
    const double moved = lattice::moved_along_earlier_sides(orthogonal_cell, k, most_cells);
    extent.lower[k] = (along[k] ? 0.0 : given.lower[k] - moved) - rounding;
    extent.upper[k] = (along[k] ? 1.0 : given.upper[k] + moved) + rounding;
  }
}

template <int Dim>
void wrap_fast(const LocalBlock& elements, const kernels::CellSideMap& map,
               const kernels::ImageKernels& kernels, std::span<exact::Sphere<Dim>> locals,
               MovedCells& cells, grid::Bounds<Dim>& bounds, kernels::BlockList& outer) {
  static_assert(sizeof(lattice::CellsMoved) == 3 * sizeof(std::int32_t));
  const auto& [given, first, count] = elements;
  kernels::CenterBounds box{};
  std::copy(bounds.lower.begin(), bounds.lower.end(), box.lower);
  std::copy(bounds.upper.begin(), bounds.upper.end(), box.upper);
  void* const out = map.pack ? static_cast<void*>(cells.words() + first)
                             : static_cast<void*>(cells.triples() + first);
  std::size_t i =
      kernels.wrap(given, first, count, Dim, map, locals[first].center, out, box, outer);
  std::copy_n(box.lower, Dim, bounds.lower.begin());
  std::copy_n(box.upper, Dim, bounds.upper.begin());
  for (; i < count; ++i) {
    exact::Sphere<Dim>& local = locals[first + i];
    local = kernels::sphere_at<Dim>(given, first + i);
    const lattice::CellsMoved moved = wrap_fast<Dim>(map, local);
    if (map.pack) {
      cells.words()[first + i] = MovedCells::packed(moved);
    } else {
      cells.triples()[first + i] = moved;
    }
    bounds.include_center(local);
    if (kernels::is_outer<Dim>(map, local)) outer.push(i);
  }
}

template kernels::CellSideMap map_of<2>(const lattice::ReducedLattice<2>&,
                                        const lattice::CellSides<2>&, const std::array<bool, 2>&,
                                        const GhostWindows<2>&);
template kernels::CellSideMap map_of<3>(const lattice::ReducedLattice<3>&,
                                        const lattice::CellSides<3>&, const std::array<bool, 3>&,
                                        const GhostWindows<3>&);
template lattice::CellExtent<2> extent_of(const kernels::StridedSpheres&, std::size_t, std::size_t,
                                          const lattice::CellSides<2>&, const grid::Bounds<2>&,
                                          const kernels::ImageKernels&);
template lattice::CellExtent<3> extent_of(const kernels::StridedSpheres&, std::size_t, std::size_t,
                                          const lattice::CellSides<3>&, const grid::Bounds<3>&,
                                          const kernels::ImageKernels&);
template struct WrapEstimate<2>;
template struct WrapEstimate<3>;
template void wrap_fast(const LocalBlock&, const kernels::CellSideMap&,
                        const kernels::ImageKernels&, std::span<exact::Sphere<2>>, MovedCells&,
                        grid::Bounds<2>&, kernels::BlockList&);
template void wrap_fast(const LocalBlock&, const kernels::CellSideMap&,
                        const kernels::ImageKernels&, std::span<exact::Sphere<3>>, MovedCells&,
                        grid::Bounds<3>&, kernels::BlockList&);

}  // namespace abut::periodic
