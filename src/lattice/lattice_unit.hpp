#pragma once

#include "exact/lattice.hpp"
#include "grid/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace abut::lattice {

/// The largest position, radius or margin of a detection.
template <int Dim>
[[nodiscard]] double largest_number(const grid::Bounds<Dim>& bounds, double margin) noexcept {
  double largest = std::max(bounds.largest_radius, margin);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis])});
  }
  return largest;
}

/// The power of two by which lattice and positions are to be multiplied before a lattice is
/// reduced. Not 1 only where a vector is so short that its inverse, or how often it fits into the
/// largest position, might exceed the numbers. Nothing is rounded then. Where `largest`, the
/// largest position or length, would exceed them instead it is 1.
template <int Dim>
[[nodiscard]] double unit_of(const exact::Lattice& lattice, double largest) noexcept {
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
  return shortest < short_vector && largest <= largest_enlarged ? enlargement : 1.0;
}

[[nodiscard]] inline exact::Lattice times(exact::Lattice lattice, double unit) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (!lattice.periodic[k]) continue;
    for (double& x : lattice.vectors[k]) x *= unit;
  }
  return lattice;
}

}  // namespace abut::lattice
