#pragma once

#include "exact/numbers/double_double.hpp"
#include "lattice/reduced_lattice.hpp"

#include <cmath>
#include <cstddef>

namespace abut::lattice {

/// A coordinate that was moved, and what it is off at most.
struct MovedCoordinate {
  double value = 0.0;
  double error = 0.0;
};

/// Moves a coordinate by so many of the vectors of a lattice, in doubled precision: off by half of
/// its last place and a little, and not at all where no vector leads along the axis
/// (docs/derivations/periodic_images.md, 4). For numbers up to 2^960, and vectors that are not
/// shorter than 2^-800.
template <int Dim>
[[nodiscard]] MovedCoordinate moved_coordinate(double coordinate, std::size_t axis,
                                               const ImageNumbers& numbers,
                                               const ReducedLattice<Dim>& lattice) noexcept {
  constexpr double last_place = 0x1.00001p-53;
  constexpr double of_all_terms = 0x1p-98;
  exact::CompensatedSum sum;
  sum.add(coordinate);
  double terms = std::fabs(coordinate);
  bool is_moved = false;
  for (std::size_t k = 0; k < lattice.count; ++k) {
    const auto number = static_cast<double>(numbers[k]);
    if (number == 0.0 || lattice.vectors[k][axis] == 0.0) continue;
    const exact::DoubleDouble step = exact::two_product(number, lattice.vectors[k][axis]);
    sum.add(step);
    sum.add(number * lattice.remainders[k][axis]);
    terms += std::fabs(step.high);
    is_moved = true;
  }
  if (!is_moved) return {coordinate, 0.0};
  const double value = sum.value().high;
  return {value, last_place * std::fabs(value) + of_all_terms * terms};
}

}  // namespace abut::lattice
