#pragma once

#include "grid/reduced_lattice.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace abut::grid {

/// From positions to fractional coordinates, as ReducedLattice::fraction, in loops over elements:
/// positions that are given times `unit`.
template <int Dim>
struct FractionMap {
  using Vector = std::array<double, Dim>;

  FractionMap(const ReducedLattice<Dim>& lattice, double unit) noexcept : count(lattice.count) {
    for (std::size_t k = 0; k < count; ++k) {
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        coefficients[k][axis] = lattice.dual[k][axis] * (lattice.scale / unit);
      }
    }
  }

  [[nodiscard]] double operator()(std::size_t k, const double* position) const noexcept {
    double sum = coefficients[k][0] * position[0];
    for (std::size_t axis = 1; axis < Dim; ++axis) sum += coefficients[k][axis] * position[axis];
    return sum;
  }

  /// Of terms as large as these. Rounding is told relative to it.
  [[nodiscard]] double magnitude(std::size_t k, const Vector& farthest) const noexcept {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sum += std::fabs(coefficients[k][axis]) * farthest[axis];
    }
    return sum;
  }

  /// Each basis vector lies along one axis: a fraction ascends or descends with one coordinate.
  [[nodiscard]] bool is_aligned() const noexcept {
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t axes = 0;
      for (const double x : coefficients[k]) axes += x != 0.0 ? 1 : 0;
      if (axes != 1) return false;
    }
    return true;
  }

  std::size_t count;
  std::array<Vector, Dim> coefficients{};
};

/// Calls body(std::integral_constant<std::size_t, count>), for loops that are to be unrolled.
template <int Dim, class Body>
decltype(auto) with_count(std::size_t count, Body&& body) {
  if (count == 1) return body(std::integral_constant<std::size_t, 1>{});
  if (Dim == 2 || count == 2) return body(std::integral_constant<std::size_t, 2>{});
  return body(std::integral_constant<std::size_t, Dim>{});
}

}  // namespace abut::grid
