#pragma once

#include "base/sphere_predicate.hpp"
#include "grid/reduced_lattice.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::grid {

/// How many cells an element was moved, along each vector of the reduced basis.
using CellsMoved = std::array<std::int32_t, 3>;

/// Moves elements into the primary cell, 0 <= f_k < 1 but for the rounding of f_k, along some of
/// the basis vectors.
template <int Dim>
class Wrapper {
 public:
  Wrapper(const ReducedLattice<Dim>& lattice, const std::array<bool, Dim>& along) noexcept;

  /// Moves a center by minus the cells returned, in doubled precision: the new coordinates are off
  /// by at most half of their last place and 2^-55 of the cell, however far they were moved, and
  /// not at all where nothing was moved. Throws Error{invalid_input} naming element `number` when
  /// it lies more than 2^31 - 1 cells outside.
  CellsMoved wrap(base::Sphere<Dim>& sphere, std::size_t number) const;

 private:
  using Cells = std::array<double, Dim>;

  [[nodiscard]] Cells cells_of(const double* position) const noexcept;
  void move(const double* from, const Cells& cells, double* to) const noexcept;

  const ReducedLattice<Dim>& lattice_;
  std::array<bool, Dim> along_;
  double unscale_;
  std::array<std::array<double, Dim>, Dim> vectors_{};  ///< times the lattice's scale
  std::array<std::array<double, Dim>, Dim> remainders_{};
};

}  // namespace abut::grid
