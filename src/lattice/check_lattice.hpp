#pragma once

#include "exact/lattice.hpp"

namespace abut::lattice {

/// Throws Error{invalid_input} unless the periodic vectors are finite and linearly independent, in
/// real arithmetic.
template <int Dim>
void check_lattice(const exact::Lattice& lattice);

}  // namespace abut::lattice
