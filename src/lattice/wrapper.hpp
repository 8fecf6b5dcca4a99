#pragma once

#include "base/host_device.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/sphere.hpp"
#include "lattice/orthogonal_cell.hpp"

#include <abut/element_view.hpp>

#include <array>
#include <cmath>
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
  double start = 0.0;           ///< of the cell along each side, in sides: -1/2 around the origin
};

/// Moves elements into the orthogonal cell at the origin, 0 <= coordinate < 1 (or from another
/// start on) but for the rounding of the coordinate, along some of its sides. Along the others they
/// move by the offsets of these.
template <int Dim>
class Wrapper {
 public:
  /// `orthogonal_cell` is for positions as given.
  Wrapper(const ReducedLattice<Dim>& lattice, const OrthogonalCell<Dim>& orthogonal_cell,
          const std::array<bool, Dim>& along, const WrapSettings& settings = {}) noexcept;

  /// Moves a center by minus the cells returned, in doubled precision: the new coordinates are off
  /// by at most half of their last place and 2^-55 of the cell, however far they were moved, and
  /// not at all where nothing was moved, but for what the result's unit takes from subnormal
  /// numbers. All lengths are multiplied by that unit. Throws Error{invalid_input} naming element
  /// `number` when it lies more than 2^31 - 1 cells outside.
  CellsMoved wrap(exact::Sphere<Dim>& sphere, std::size_t number) const;

  /// Does the same, and returns whether the element lies near enough; else it stays where it is.
  [[nodiscard]] ABUT_HD bool wrap_if_near(exact::Sphere<Dim>& sphere,
                                          CellsMoved& cells_moved) const noexcept {
    Cells cells = cells_of(sphere.center, 1.0);
    if (!are_few(cells)) return false;
    exact::Sphere<Dim> there = sphere;
    there.radius *= settings_.result_unit;
    move(sphere.center, cells, there.center);
    if (are_some(cells)) {
      // Far outside, the quotient is off by some cells' hundredth: once more, from close by.
      const Cells rest = cells_of(there.center, 1.0 / settings_.result_unit);
      if (are_some(rest)) {
        for (std::size_t k = 0; k < Dim; ++k) cells[k] += rest[k];
        if (!are_few(cells)) return false;
        move(sphere.center, cells, there.center);
      }
    }
    sphere = there;
    for (std::size_t k = 0; k < Dim; ++k) cells_moved[k] = static_cast<std::int32_t>(cells[k]);
    return true;
  }

  /// Moves one coordinate of a center by minus those cells, as `wrap` does.
  [[nodiscard]] ABUT_HD double moved(double coordinate, std::size_t axis,
                                     const CellsMoved& cells_moved) const noexcept {
    Cells cells{};
    for (std::size_t k = 0; k < Dim; ++k) cells[k] = cells_moved[k];
    return moved(coordinate, axis, cells);
  }

 private:
  using Cells = std::array<double, Dim>;  ///< of the sides

  [[nodiscard]] ABUT_HD static bool are_some(const Cells& cells) noexcept {
    bool some = false;
    for (std::size_t k = 0; k < Dim; ++k) some = some || cells[k] != 0.0;
    return some;
  }
  [[nodiscard]] ABUT_HD static bool are_few(const Cells& cells) noexcept {
    bool few = true;
    for (std::size_t k = 0; k < Dim; ++k) few = few && std::fabs(cells[k]) <= most_cells_away;
    return few;
  }

  [[nodiscard]] ABUT_HD Cells cells_of(const double* position, double times) const noexcept {
    Cells cells{};
    for (std::size_t k = 0; k < Dim; ++k) {
      if (k >= orthogonal_cell_.count) break;
      if (!along_[k]) continue;
      double place = orthogonal_cell_.coordinate(k, position) * times;
      for (std::size_t l = 0; l < k; ++l) place -= cells[l] * orthogonal_cell_.offset[l][k];
      cells[k] = std::floor(place - settings_.start);
    }
    return cells;
  }

  ABUT_HD void move(const double* from, const Cells& cells, double* to) const noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) to[axis] = moved(from[axis], axis, cells);
  }

  [[nodiscard]] ABUT_HD double moved(double coordinate, std::size_t axis,
                                     const Cells& cells) const noexcept {
    // Where no vector leads nothing is added, and the coordinate may be too large for the scale.
    if (!is_led_along_[axis] || !are_some(cells)) return coordinate * settings_.result_unit;
    exact::CompensatedSum sum;
    sum.add(coordinate * scale_);
    for (std::size_t k = 0; k < Dim; ++k) {
      if (k >= orthogonal_cell_.count) break;
      // Mostly, vectors lie along axes and are not rounded.
      if (cells[k] == 0.0 || vectors_[k][axis] == 0.0) continue;
      sum.add(exact::two_product(-cells[k], vectors_[k][axis]));
      if (remainders_[k][axis] != 0.0) sum.add(-cells[k] * remainders_[k][axis]);
    }
    return sum.value().high * to_result_[0] * to_result_[1];
  }

  OrthogonalCell<Dim> orthogonal_cell_;
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
