#pragma once

#include "lattice/reduced_lattice.hpp"

namespace abut::lattice {

/// Returns the largest power of two of which all components of the basis are multiples; 0 where
/// doubles do not hold the basis.
template <int Dim>
[[nodiscard]] double step_of(const ReducedLattice<Dim>& lattice) noexcept;

}  // namespace abut::lattice
