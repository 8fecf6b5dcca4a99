#pragma once

#include "lattice/cell_sides.hpp"
#include "lattice/reduced_lattice.hpp"

namespace abut::lattice {

/// A cell of a lattice that is a block, whatever the angles of its vectors: side 0 is perpendicular
/// to all vectors but one, side 1 to all vectors but that and another, and so on (J. Gram, E.
/// Schmidt). Where vectors are the rows of a triangular matrix, of any order of its rows and
/// columns, its sides lie along the axes of space.
template <int Dim>
struct OrthogonalCell : CellSides<Dim> {
  using Vector = typename CellSides<Dim>::Vector;

  /// Makes the cell for positions that are given times `unit`. Throws Error{invalid_input} where
  /// rounding spoils it (docs/derivations/periodic_images.md, 1).
  OrthogonalCell(const ReducedLattice<Dim>& lattice, double unit);
};

}  // namespace abut::lattice
