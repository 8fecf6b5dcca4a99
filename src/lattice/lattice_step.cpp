#include "lattice/lattice_step.hpp"

#include "exact/numbers/bit_range.hpp"

#include <cmath>
#include <cstddef>

namespace abut::lattice {

template <int Dim>
double step_of(const ReducedLattice<Dim>& lattice) noexcept {
  exact::BitRange bits;
  for (std::size_t k = 0; k < lattice.count; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (lattice.remainders[k][axis] != 0.0) return 0.0;
      bits.include(lattice.vectors[k][axis]);
    }
  }
  return std::ldexp(1.0, bits.lowest());
}

template double step_of(const ReducedLattice<2>&) noexcept;
template double step_of(const ReducedLattice<3>&) noexcept;

}  // namespace abut::lattice
