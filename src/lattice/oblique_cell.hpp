#pragma once

#include "lattice/cell_sides.hpp"
#include "lattice/reduced_lattice.hpp"

namespace abut::lattice {

/// The cell that the vectors of the reduced basis span: its coordinates are the fractions of the
/// vectors, so that moving by one of them changes its own coordinate only. Elements in such a cell
/// must not be moved to have few images, whatever its angles.
template <int Dim>
struct ObliqueCell : CellSides<Dim> {
  /// Makes the cell for positions that are given times `unit`.
  ObliqueCell(const ReducedLattice<Dim>& lattice, double unit);
};

}  // namespace abut::lattice
