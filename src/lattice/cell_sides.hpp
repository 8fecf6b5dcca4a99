#pragma once

#include "base/host_device.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace abut::lattice {

/// Largest number of cells that an element or an image may lie away.
inline constexpr double most_cells_away = 2147483647.0;

/// Coordinates along the sides of a cell of a lattice. Coordinate k, a linear function of the
/// position, tells the place along side k in units of that side. Moving by the vector of side k
/// adds 1 to coordinate k, offset[k][l] to each later coordinate l, and nothing to earlier ones.
template <int Dim>
struct CellSides {
  using Vector = std::array<double, Dim>;

  std::size_t count = 0;                     ///< sides
  std::array<std::size_t, Dim> vector_of{};  ///< of the reduced basis
  std::array<Vector, Dim> coefficients{};
  std::array<Vector, Dim> offset{};
  /// Sums of the products of the coefficients of side k and the vector of side l: of the magnitudes
  /// of the terms, and a bound of the error of the sum, which should be 1, the offset, or 0. Where
  /// the sides lie along the axes both are 0 for l > k, and for l < k where the offset is 0.
  std::array<Vector, Dim> weight{};
  std::array<Vector, Dim> error{};
  Vector dual_length{};  ///< of the coefficients without the unit, times the lattice's scale
  Vector rise{};         ///< the same, sum of the positive coefficients
  Vector fall{};         ///< the same, sum of the magnitudes of the negative ones

  [[nodiscard]] ABUT_HD double coordinate(std::size_t k, const double* position) const noexcept {
    double sum = coefficients[k][0] * position[0];
    for (std::size_t axis = 1; axis < Dim; ++axis) sum += coefficients[k][axis] * position[axis];
    return sum;
  }

  /// Magnitude of a coordinate whose terms are as large as these; errors are relative to it.
  [[nodiscard]] double magnitude(std::size_t k, const Vector& farthest) const noexcept {
    double sum = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sum += std::fabs(coefficients[k][axis]) * farthest[axis];
    }
    return sum;
  }

  /// True if each side lies along an axis: a coordinate ascends or descends with one of the
  /// position's.
  [[nodiscard]] bool is_aligned() const noexcept {
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t axes = 0;
      for (const double x : coefficients[k]) axes += x != 0.0 ? 1 : 0;
      if (axes != 1) return false;
    }
    return true;
  }
};

/// Calls body(std::integral_constant<std::size_t, count>), for loops that are to be unrolled.
template <int Dim, class Body>
decltype(auto) with_count(std::size_t count, Body&& body) {
  if (count == 1) return body(std::integral_constant<std::size_t, 1>{});
  if (Dim == 2 || count == 2) return body(std::integral_constant<std::size_t, 2>{});
  return body(std::integral_constant<std::size_t, Dim>{});
}

}  // namespace abut::lattice
