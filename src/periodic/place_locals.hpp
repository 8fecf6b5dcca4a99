#pragma once

#include "base/array.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "kernels/images/image_kernels.hpp"
#include "lattice/cell_extent.hpp"
#include "lattice/orthogonal_cell.hpp"
#include "lattice/wrap_rules.hpp"
#include "lattice/wrapper.hpp"
#include "periodic/list_ghosts.hpp"
#include "periodic/moved_cells.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace abut::periodic {

/// The numbers of a cell for vector kernels: who may have ghosts, as the windows say.
template <int Dim>
[[nodiscard]] kernels::CellSideMap map_of(const lattice::ReducedLattice<Dim>& lattice,
                                          const lattice::CellSides<Dim>& cell,
                                          const std::array<bool, Dim>& along,
                                          const GhostWindows<Dim>& windows);

/// The extent of the spheres [first, first + count) along the sides of a cell; `bounds` are those
/// of all spheres.
template <int Dim>
[[nodiscard]] lattice::CellExtent<Dim> extent_of(const kernels::StridedSpheres& spheres,
                                                 std::size_t first, std::size_t count,
                                                 const lattice::CellSides<Dim>& cell,
                                                 const grid::Bounds<Dim>& bounds,
                                                 const kernels::ImageKernels& kernels);

/// Moves that bring some elements into the orthogonal cell at the origin.
template <int Dim>
struct WrapEstimate {
  WrapEstimate(const lattice::ReducedLattice<Dim>& lattice,
               const lattice::OrthogonalCell<Dim>& orthogonal_cell,
               const lattice::CellExtent<Dim>& extent, const std::array<bool, Dim>& along);

  std::array<double, Dim> most_cells{};  ///< along each side, an upper bound
  lattice::CellExtent<Dim> extent;       ///< after a quick move; holds all elements

  /// True if elements are so close by that a fast wrap leaves them in `extent`.
  bool is_short = true;
};

/// Moves elements as lattice::Wrapper does, but in plain doubles, each product and sum rounded: off
/// by less than 7 u (|x| + moved distance) on an axis. For short ways, and a block of
/// elements, which go to the places of their numbers in `locals`. Lists those that may have ghosts
/// then.
template <int Dim>
void wrap_fast(const LocalBlock& elements, const kernels::CellSideMap& map,
               const kernels::ImageKernels& kernels, std::span<exact::Sphere<Dim>> locals,
               MovedCells& cells, grid::Bounds<Dim>& bounds, kernels::BlockList& outer);

}  // namespace abut::periodic
