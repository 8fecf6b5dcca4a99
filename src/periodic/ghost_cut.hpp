#pragma once

#include "engine/sizes/radius_histogram.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "kernels/strided_spheres.hpp"
#include "lattice/reduced_lattice.hpp"

#include <span>

namespace abut::periodic {

/// GhostWindows::cut: the radius from which on spheres should be large; infinite where that saves
/// little.
///
/// The estimate: elements fill the cell evenly, and a ghost costs as much as a local element.
template <int Dim>
[[nodiscard]] double choose_ghost_cut(const kernels::StridedSpheres& spheres,
                                      const grid::Bounds<Dim>& bounds,
                                      const lattice::ReducedLattice<Dim>& lattice, double margin,
                                      engine::RadiusHistogram& histogram);

}  // namespace abut::periodic
