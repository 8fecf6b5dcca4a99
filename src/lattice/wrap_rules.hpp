#pragma once

#include "lattice/cell_extent.hpp"
#include "lattice/cell_sides.hpp"
#include "lattice/ghost_window.hpp"
#include "lattice/reduced_lattice.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cmath>
#include <cstddef>

/// What is decided of all elements of a periodic domain before any is moved: along which sides of
/// a cell, and how far all that is rounded may put them off
/// (docs/derivations/periodic_images.md, 4).
namespace abut::lattice {

/// A choice for each side of a cell.
template <int Dim>
using AlongSides = std::array<bool, Dim>;

/// The distance along side k, in sides, that so many cells along earlier sides move an element by.
template <int Dim>
[[nodiscard]] double moved_along_earlier_sides(
    const CellSides<Dim>& cell, std::size_t k,
    const typename CellSides<Dim>::Vector& cells) noexcept {
  double moved = 0.0;
  for (std::size_t l = 0; l < k; ++l) moved += std::fabs(cell.offset[l][k]) * cells[l];
  return moved;
}

/// Upper bounds of the cells by which elements of that extent are moved along each of some sides.
template <int Dim>
[[nodiscard]] std::array<double, Dim> most_cells_moved(const CellSides<Dim>& cell,
                                                       const CellExtent<Dim>& extent,
                                                       const AlongSides<Dim>& along) noexcept;

/// Elements are moved along the sides that they spread over more than a cell of. A little more, a
/// quarter of what ghosts are within, costs fewer ghosts than moving elements costs time. What
/// overflows is left to the wrapper, which knows the element.
///
/// Moved along an earlier side, elements move along this one, too, and are brought back if they
/// have gone far. Where this side is far longer than the earlier one they have not: then some of
/// those on both sides of a face would be moved by a long vector, and all rounding would be
/// relative to that.
///
/// Where numbers of cells may be too large, they are moved along all sides or none: it is along all
/// that check_range looks at each element.
template <int Dim>
[[nodiscard]] AlongSides<Dim> sides_to_wrap(const CellSides<Dim>& cell,
                                            const CellExtent<Dim>& extent,
                                            const GhostWindow<Dim>& window) noexcept;

/// True if all elements of that extent are far from what check_range refuses.
template <int Dim>
[[nodiscard]] bool is_in_range(const CellSides<Dim>& cell, const CellExtent<Dim>& extent,
                               const GhostWindow<Dim>& window) noexcept;

/// Vectors of the sides times a unit, 0 where there are fewer sides than axes.
template <int Dim>
using SideSteps = std::array<std::array<double, Dim>, Dim>;

template <int Dim>
[[nodiscard]] SideSteps<Dim> side_steps(const ReducedLattice<Dim>& lattice,
                                        const CellSides<Dim>& cell, double unit) noexcept;

/// The distance of two locals, or of a local element and a ghost, from where they are stored, is
/// off by at most this part of magnitude_of if locals were moved by Wrapper, or not at all.
inline constexpr double slack_of_ghosts = 0x1p-48;

/// Cells of a search are at least so many times as long as that error
/// (docs/derivations/tile_filter.md, section 3).
inline constexpr double cells_of_error = 0x1p24;

/// The magnitude to which rounding is relative, of elements that are `width` wide beside their
/// position. Where locals are moved and images made along no vector that leads along an axis,
/// nothing is added to coordinates on it.
template <int Dim>
[[nodiscard]] double magnitude_of(const CellExtent<Dim>& extent, const GhostWindow<Dim>& window,
                                  const AlongSides<Dim>& along, const SideSteps<Dim>& steps,
                                  double width) noexcept;

/// Upper bounds of the shifts of pairs, in terms of the lattice as given, if no element is moved by
/// more cells than that.
template <int Dim>
[[nodiscard]] std::array<double, 3> most_shifts(
    const ReducedLattice<Dim>& lattice, const CellSides<Dim>& cell, const GhostWindow<Dim>& window,
    const std::array<double, Dim>& cells_moved_at_most) noexcept;

/// Shifts up to this bound, which is off by what doubles round, fit 32 bits.
inline constexpr double largest_bound_of_shifts = 0x1p30;

}  // namespace abut::lattice
