#include "periodic/place_natives.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::engine {
namespace {

/// One element of move_quickly.
template <int Dim>
grid::CellsMoved move_quickly(const kernels::BrickMap& map, base::Sphere<Dim>& sphere) {
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
  grid::CellsMoved moved{};
  for (std::size_t k = 0; k < 3; ++k) moved[k] = static_cast<std::int32_t>(cells[k]);
  return moved;
}

}  // namespace

template <int Dim>
kernels::BrickMap map_of(const grid::ReducedLattice<Dim>& lattice, const grid::Brick<Dim>& brick,
                         const std::array<bool, Dim>& along, const GhostWindows<Dim>& windows) {
  kernels::BrickMap map{};
  map.sides = brick.count;
  map.outer_from_radius = windows.cut;
  for (std::size_t k = 0; k < brick.count; ++k) {
    map.along[k] = along[k];
    map.outer_below[k] = windows.of_small.outer_below()[k];
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      map.coefficients[k][axis] = brick.coefficients[k][axis];
      map.vectors[k][axis] = lattice.vectors[brick.vector_of[k]][axis];
    }
    for (std::size_t l = 0; l < brick.count; ++l) map.offset[k][l] = brick.offset[k][l];
  }
  return map;
}

template <int Dim>
Journey<Dim>::Journey(const grid::ReducedLattice<Dim>& lattice, const grid::Brick<Dim>& brick,
                      const grid::CellExtent<Dim>& given, const std::array<bool, Dim>& along)
    : extent(given) {
  constexpr double longest = 0x1p24;  // in sides
  constexpr double rounding = 0x1p-20;
  for (std::size_t k = 0; k < brick.count; ++k) {
    if (!along[k]) continue;
    most_cells[k] = brick.magnitude(k, given.farthest) + 2.0;
    for (std::size_t l = 0; l < k; ++l) {
      most_cells[k] += std::fabs(brick.offset[l][k]) * most_cells[l];
    }
  }
  for (std::size_t k = 0; k < brick.count; ++k) {
    const auto& vector = lattice.vectors[brick.vector_of[k]];
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      extent.farthest[axis] += most_cells[k] * std::fabs(vector[axis]);
    }
    double distance = brick.magnitude(k, given.farthest);
    for (std::size_t l = 0; l < brick.count; ++l) {
      distance += brick.dual_length[k] * (lattice.length[brick.vector_of[l]] * lattice.scale) *
                  most_cells[l];
    }
    is_short = is_short && distance <= longest;
    extent.lower[k] = (along[k] ? 0.0 : given.lower[k]) - rounding;
    extent.upper[k] = (along[k] ? 1.0 : given.upper[k]) + rounding;
  }
}

template <int Dim>
void move_quickly(std::span<const base::Sphere<Dim>> elements, const kernels::BrickMap& map,
                  const kernels::ImageKernels& kernels, std::span<base::Sphere<Dim>> natives,
                  MovedCells& cells, std::size_t first, grid::Bounds<Dim>& bounds,
                  kernels::BlockList& outer) {
  static_assert(sizeof(grid::CellsMoved) == 3 * sizeof(std::int32_t));
  kernels::CenterBounds box{};
  std::copy(bounds.lower.begin(), bounds.lower.end(), box.lower);
  std::copy(bounds.upper.begin(), bounds.upper.end(), box.upper);
  void* const out = map.pack ? static_cast<void*>(cells.words() + first)
                             : static_cast<void*>(cells.triples() + first);
  std::size_t i = kernels.wrap(elements[0].center, elements.size(), Dim, map, natives[0].center,
                               out, box, outer);
  std::copy_n(box.lower, Dim, bounds.lower.begin());
  std::copy_n(box.upper, Dim, bounds.upper.begin());
  for (; i < elements.size(); ++i) {
    natives[i] = elements[i];
    const grid::CellsMoved moved = move_quickly<Dim>(map, natives[i]);
    if (map.pack) {
      cells.words()[first + i] = MovedCells::packed(moved);
    } else {
      cells.triples()[first + i] = moved;
    }
    bounds.include_center(natives[i]);
    if (kernels::is_outer<Dim>(map, natives[i].center)) outer.push(i);
  }
}

template kernels::BrickMap map_of<2>(const grid::ReducedLattice<2>&, const grid::Brick<2>&,
                                     const std::array<bool, 2>&, const GhostWindows<2>&);
template kernels::BrickMap map_of<3>(const grid::ReducedLattice<3>&, const grid::Brick<3>&,
                                     const std::array<bool, 3>&, const GhostWindows<3>&);
template struct Journey<2>;
template struct Journey<3>;
template void move_quickly(std::span<const base::Sphere<2>>, const kernels::BrickMap&,
                           const kernels::ImageKernels&, std::span<base::Sphere<2>>, MovedCells&,
                           std::size_t, grid::Bounds<2>&, kernels::BlockList&);
template void move_quickly(std::span<const base::Sphere<3>>, const kernels::BrickMap&,
                           const kernels::ImageKernels&, std::span<base::Sphere<3>>, MovedCells&,
                           std::size_t, grid::Bounds<3>&, kernels::BlockList&);

}  // namespace abut::engine
