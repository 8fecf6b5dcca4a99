#pragma once

#include "lattice/cell_sides.hpp"
#include "lattice/dot.hpp"
#include "lattice/reduced_lattice.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

/// What follows from the coefficients of sides, for their makers. Vectors and coefficients are
/// those times the scale of the lattice until `scale_sides` is called.
namespace abut::lattice {

template <int Dim>
using Vectors = std::array<std::array<double, Dim>, Dim>;

template <int Dim>
[[nodiscard]] inline double length_of(const std::array<double, Dim>& vector) {
  return std::sqrt(dot<Dim>(vector, vector));
}

/// The vectors of a lattice times its scale.
template <int Dim>
[[nodiscard]] Vectors<Dim> scaled_vectors(const ReducedLattice<Dim>& lattice) {
  Vectors<Dim> scaled{};
  for (std::size_t v = 0; v < lattice.count; ++v) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      scaled[v][axis] = lattice.vectors[v][axis] * lattice.scale;
    }
  }
  return scaled;
}

/// Measures the coefficients: their length, and the sums by sign.
template <int Dim>
void measure_lengths(CellSides<Dim>& sides) {
  for (std::size_t k = 0; k < sides.count; ++k) {
    sides.dual_length[k] = length_of<Dim>(sides.coefficients[k]) * (1.0 + 0x1p-40);
    for (const double x : sides.coefficients[k]) {
      (x > 0.0 ? sides.rise : sides.fall)[k] += std::fabs(x);
    }
    sides.rise[k] *= 1.0 + 0x1p-40;
    sides.fall[k] *= 1.0 + 0x1p-40;
  }
}

/// Bounds the errors of coordinates. The rounding of three products and two sums, and of the vector
/// itself, is below 2^-50 of the weight; the difference to what is expected is exact, or rounded
/// once.
template <int Dim>
void measure_errors(std::span<const std::array<double, Dim>> vectors, CellSides<Dim>& sides) {
  for (std::size_t k = 0; k < sides.count; ++k) {
    for (std::size_t l = 0; l < sides.count; ++l) {
      const auto& vector = vectors[sides.vector_of[l]];
      double weight = 0.0;
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        weight += std::fabs(sides.coefficients[k][axis] * vector[axis]);
      }
      const double product = dot<Dim>(sides.coefficients[k], vector);
      const double expected = l == k ? 1.0 : (l < k ? sides.offset[l][k] : 0.0);
      sides.weight[k][l] = weight * (1.0 + 0x1p-40);
      sides.error[k][l] = (std::fabs(product - expected) + 0x1p-50 * weight) * (1.0 + 0x1p-40);
    }
  }
}

/// Makes the coefficients those for positions that are given times `unit`.
template <int Dim>
void scale_sides(const ReducedLattice<Dim>& lattice, double unit, CellSides<Dim>& sides) {
  for (auto& row : sides.coefficients) {
    for (double& x : row) {
      if (x != 0.0) x *= lattice.scale / unit;
    }
  }
}

}  // namespace abut::lattice
