#pragma once

#include "base/array.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "kernels/image_kernels.hpp"
#include "lattice/brick.hpp"
#include "lattice/cell_extent.hpp"
#include "lattice/wrapper.hpp"
#include "periodic/list_ghosts.hpp"
#include "periodic/moved_cells.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace abut::engine {

/// What vector kernels need to know of a brick: who may have ghosts, as the windows say.
template <int Dim>
[[nodiscard]] kernels::BrickMap map_of(const grid::ReducedLattice<Dim>& lattice,
                                       const grid::Brick<Dim>& brick,
                                       const std::array<bool, Dim>& along,
                                       const GhostWindows<Dim>& windows);

/// How far some elements must be moved in order to lie in the brick at the origin.
template <int Dim>
struct Journey {
  Journey(const grid::ReducedLattice<Dim>& lattice, const grid::Brick<Dim>& brick,
          const grid::CellExtent<Dim>& extent, const std::array<bool, Dim>& along);

  std::array<double, Dim> most_cells{};  ///< along each side, an upper bound
  grid::CellExtent<Dim> extent;          ///< after a quick move; holds all elements

  /// Whether elements are so close by that a quick move leaves them in `extent`.
  bool is_short = true;
};

/// Moves elements as grid::Wrapper does, but in plain doubles, each product and sum rounded: off by
/// less than 7 u (|x| + moved distance) on an axis. For short journeys, and a block of elements,
/// the first of which has the number `first`. Lists those that may have ghosts then.
template <int Dim>
void move_quickly(std::span<const base::Sphere<Dim>> elements, const kernels::BrickMap& map,
                  const kernels::ImageKernels& kernels, std::span<base::Sphere<Dim>> natives,
                  MovedCells& cells, std::size_t first, grid::Bounds<Dim>& bounds,
                  kernels::BlockList& outer);

}  // namespace abut::engine
