#pragma once

#include "lattice/orthogonal_cell.hpp"
#include "lattice/reduced_lattice.hpp"

#include <cstddef>

namespace abut::lattice {

/// Makes every side of the orthogonal cell lead against the axes of space, rather than along them:
/// images along it, of which ghosts are made, are then within reach of locals as far as they are
/// wide themselves. In the other direction it would be as far as the widest local element is, and
/// one wide wall would make ghosts of all elements. So boxes have another cell at the origin than
/// spheres, whatever algorithm searches them.
template <int Dim>
void turn_downwards(ReducedLattice<Dim>& lattice) {
  if (lattice.count == 0) return;
  const OrthogonalCell<Dim> orthogonal_cell(lattice, 1.0);
  for (std::size_t k = 0; k < orthogonal_cell.count; ++k) {
    if (orthogonal_cell.rise[k] > orthogonal_cell.fall[k])
      lattice.turn(orthogonal_cell.vector_of[k]);
  }
}

}  // namespace abut::lattice
