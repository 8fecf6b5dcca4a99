#pragma once

#include "exact/lattice.hpp"
#include "exact/simplices/point.hpp"

#include <array>
#include <cstddef>

namespace abut::exact {

/// What moves some of the points of a pair: steps along lattice vectors, and what rounding does to
/// the coordinates that are moved.
struct Move {
  const LatticeSteps<3>& steps;
  double error;  ///< `near` of all points is off by less; infinite where rounding has no bound
};

/// A point that a move may move: its coordinates are the real numbers x + n A.
template <int Dim>
struct MovedPoint {
  Point<Dim> given;
  Point<Dim> near;   ///< the coordinates as rounded numbers; `given` of a point that stays
  const Move* move;  ///< that of the pair, also of points that stay
  bool is_moved;
  std::array<std::size_t, Dim> axes;  ///< axis of the lattice along which each coordinate runs

  /// In real arithmetic.
  [[nodiscard]] bool operator==(const MovedPoint& other) const noexcept;
};

/// -1, 0 or 1: the sign of a - b along an axis, in real arithmetic.
template <int Dim>
[[nodiscard]] int compare_along(std::size_t axis, const MovedPoint<Dim>& a,
                                const MovedPoint<Dim>& b) noexcept;
template <std::size_t Dim>
[[nodiscard]] int compare_along(std::size_t axis, const std::array<double, Dim>& a,
                                const std::array<double, Dim>& b) noexcept {
  return (a[axis] > b[axis]) - (a[axis] < b[axis]);
}

/// The points of the plane that is left without an axis of space.
[[nodiscard]] inline Point<2> without_axis(const Point<3>& point, std::size_t axis) noexcept {
  return {point[axis == 0 ? 1 : 0], point[axis == 2 ? 1 : 2]};
}
[[nodiscard]] inline MovedPoint<2> without_axis(const MovedPoint<3>& point,
                                                std::size_t axis) noexcept {
  return {without_axis(point.given, axis),
          without_axis(point.near, axis),
          point.move,
          point.is_moved,
          {axis == 0 ? std::size_t{1} : 0, axis == 2 ? std::size_t{1} : 2}};
}

template <class P>
inline constexpr int dimensions_of = 0;
template <std::size_t Dim>
inline constexpr int dimensions_of<std::array<double, Dim>> = static_cast<int>(Dim);
template <int Dim>
inline constexpr int dimensions_of<MovedPoint<Dim>> = Dim;

}  // namespace abut::exact
