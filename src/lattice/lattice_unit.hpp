#pragma once

#include "exact/lattice.hpp"
#include "grid/scaling.hpp"
#include "lattice/reduced_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace abut::lattice {

/// A lattice vector is below 2^-800, and some number above 2^720.
[[noreturn]] void refuse_range_of_numbers();

/// The power of two by which lattice and positions are to be multiplied before a lattice is
/// reduced. Not 1 only where a vector is so short that its inverse, or how often it fits into the
/// largest position, might exceed the numbers. Nothing is rounded then. Throws Error{invalid_input}
/// where `largest`, the largest position, length or margin, would exceed them instead.
template <int Dim>
[[nodiscard]] double unit_of(const exact::Lattice& lattice, double largest) {
  constexpr double short_vector = 0x1p-800;
  constexpr double enlargement = 0x1p200;
  constexpr double largest_enlarged = 0x1p720;
  double shortest = HUGE_VAL;
  for (std::size_t k = 0; k < Dim; ++k) {
    if (!lattice.periodic[k]) continue;
    double length = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      length = std::max(length, std::fabs(lattice.vectors[k][axis]));
    }
    shortest = std::min(shortest, length);
    largest = std::max(largest, length);
  }
  if (!(shortest < short_vector)) return 1.0;
  if (largest > largest_enlarged) refuse_range_of_numbers();
  return enlargement;
}

/// The power of two by which positions that were moved are kept: not 1 only where they, or sums of
/// them, might exceed the numbers. `largest` as above.
template <int Dim>
[[nodiscard]] double unit_of_moved(const ReducedLattice<Dim>& lattice, double largest) noexcept {
  for (std::size_t k = 0; k < lattice.count; ++k) largest = std::max(largest, lattice.length[k]);
  return largest > grid::largest_unscaled ? grid::scale_down : 1.0;
}

[[nodiscard]] inline exact::Lattice times(exact::Lattice lattice, double unit) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!lattice.periodic[k]) continue;
    for (double& x : lattice.vectors[k]) x *= unit;
  }
  return lattice;
}

}  // namespace abut::lattice
