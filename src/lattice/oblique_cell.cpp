#include "lattice/oblique_cell.hpp"

#include "lattice/measure_sides.hpp"

#include <span>

namespace abut::lattice {

template <int Dim>
ObliqueCell<Dim>::ObliqueCell(const ReducedLattice<Dim>& lattice, double unit) {
  this->count = lattice.count;
  this->coefficients = lattice.dual;
  for (std::size_t k = 0; k < lattice.count; ++k) this->vector_of[k] = k;
  const Vectors<Dim> scaled = scaled_vectors<Dim>(lattice);
  measure_lengths<Dim>(*this);
  measure_errors<Dim>(std::span(scaled).first(this->count), *this);
  scale_sides<Dim>(lattice, unit, *this);
}

template struct ObliqueCell<2>;
template struct ObliqueCell<3>;

}  // namespace abut::lattice
