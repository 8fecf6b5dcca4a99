#pragma once

#include "exact/sphere.hpp"
#include "lattice/orthogonal_cell.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::lattice {

/// The number of cells by which an element was moved, along the vector of each side of an
/// orthogonal cell.
using CellsMoved = std::array<std::int32_t, 3>;

struct WrapSettings {
  Shape shape = Shape::sphere;  ///< says what errors call a position
  double given_unit = 1.0;      ///< what the caller's positions were multiplied by
  double result_unit = 1.0;     ///< what is moved is multiplied by, a power of two of 1 at most
};

/// Moves elements into the orthogonal cell at the origin, 0 <= coordinate < 1 but for the rounding
/// of the coordinate, along some of its sides. Along the others they move by the offsets of these.
template <int Dim>
class Wrapper {
 public:
  /// `orthogonal_cell` is for positions as given, and must live on.
  Wrapper(const ReducedLattice<Dim>& lattice, const OrthogonalCell<Dim>& orthogonal_cell,
          const std::array<bool, Dim>& along, const WrapSettings& settings = {}) noexcept;

  /// Moves a center by minus the cells returned, in doubled precision: the new coordinates are off
  /// by at most half of their last place and 2^-55 of the cell, however far they were moved, and
  /// not at all where nothing was moved, but for what the result's unit takes from subnormal
  /// numbers. All lengths are multiplied by that unit. Throws Error{invalid_input} naming element
  /// `number` when it lies more than 2^31 - 1 cells outside.
  CellsMoved wrap(exact::Sphere<Dim>& sphere, std::size_t number) const;

 private:
  using Cells = std::array<double, Dim>;  ///< of the sides

  [[nodiscard]] Cells cells_of(const double* position, double times) const noexcept;
  void move(const double* from, const Cells& cells, double* to) const noexcept;

  const OrthogonalCell<Dim>& orthogonal_cell_;
  std::array<bool, Dim> along_;
  WrapSettings settings_;
  double scale_;
  std::array<double, 2>
      to_result_{};  ///< from positions times the scale: first one, then the other
  std::array<bool, Dim> is_led_along_{};                ///< by some vector, each axis of space
  std::array<std::array<double, Dim>, Dim> vectors_{};  ///< of the sides, times the scale
  std::array<std::array<double, Dim>, Dim> remainders_{};
};

}  // namespace abut::lattice
