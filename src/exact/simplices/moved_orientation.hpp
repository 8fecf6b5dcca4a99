#pragma once

#include "exact/simplices/moved_point.hpp"
#include "exact/simplices/orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

// The filters beside a lattice. Coordinates that are moved are off by an absolute error, so the
// bands are absolute, too. With Q the largest magnitude of a difference and the error E together
// and u = 2^-53, a computed determinant errs by less than 49 u Q^3 + 19 E Q^2, in the plane by
// less than 9 u Q^2 + 5 E Q, while Q is within the limits. docs/derivations/orientation.md.
namespace abut::exact {

inline constexpr double band_of_moved = 0x1p-46;        // 128 u, in space
inline constexpr double band_of_moved_plane = 0x1p-48;  // 32 u, in the plane
inline constexpr double errors_of_moved = 32.0;
inline constexpr double errors_of_moved_plane = 8.0;
inline constexpr double smallest_safe_difference = 0x1p-300;
inline constexpr double largest_safe_difference = 0x1p300;

/// The signs of orientation_exactly, in real arithmetic on points that are moved.
[[nodiscard]] int orientation_exactly(const MovedPoint<2>& a, const MovedPoint<2>& b,
                                      const MovedPoint<2>& c) noexcept;
[[nodiscard]] int orientation_exactly(const MovedPoint<3>& a, const MovedPoint<3>& b,
                                      const MovedPoint<3>& c, const MovedPoint<3>& d) noexcept;

/// b - a. Where both are moved, or none is, only this subtraction rounds.
template <int Dim>
[[nodiscard]] Point<Dim> difference(const MovedPoint<Dim>& a, const MovedPoint<Dim>& b) noexcept {
  const bool alike = a.is_moved == b.is_moved;
  const Point<Dim>& from = alike ? a.given : a.near;
  const Point<Dim>& to = alike ? b.given : b.near;
  Point<Dim> result;
  for (std::size_t axis = 0; axis < Dim; ++axis) result[axis] = to[axis] - from[axis];
  return result;
}

/// The largest magnitude in some vectors.
template <int Dim, std::size_t Count>
[[nodiscard]] double largest_of(const std::array<Point<Dim>, Count>& vectors) noexcept {
  double largest = 0.0;
  for (const Point<Dim>& vector : vectors) {
    for (const double x : vector) largest = std::max(largest, std::fabs(x));
  }
  return largest;
}

[[nodiscard]] inline bool is_safe_difference(double size) noexcept {
  return size >= smallest_safe_difference && size <= largest_safe_difference;
}

template <>
class Hyperplane<MovedPoint<2>> {
 public:
  Hyperplane(const MovedPoint<2>& a, const MovedPoint<2>& b) noexcept
      : a_(a), b_(b), along_(difference(a, b)) {}

  /// The orientation of the two points and c, if the filter is certain.
  [[nodiscard]] std::optional<int> certain_side(const MovedPoint<2>& c) const noexcept {
    const Point<2> to = difference(a_, c);
    const double error = a_.move->error;
    const double size = largest_of<2, 2>({along_, to}) + error;
    const double value = along_[0] * to[1] - along_[1] * to[0];
    const double band = size * (band_of_moved_plane * size + errors_of_moved_plane * error);
    if (!(is_safe_difference(size) && std::fabs(value) > band)) return {};
    return value < 0.0 ? -1 : 1;
  }

  /// The orientation of the two points and c. Adds one to `exact_decisions` when arithmetic
  /// without rounding must decide.
  [[nodiscard]] int side(const MovedPoint<2>& c, std::uint64_t& exact_decisions) const noexcept {
    if (const auto certain = certain_side(c)) return *certain;
    if (c == a_ || c == b_) return 0;
    ++exact_decisions;
    return orientation_exactly(a_, b_, c);
  }

 private:
  MovedPoint<2> a_, b_;
  Point<2> along_;
};

template <>
class Hyperplane<MovedPoint<3>> {
 public:
  Hyperplane(const MovedPoint<3>& a, const MovedPoint<3>& b, const MovedPoint<3>& c) noexcept
      : a_(a), b_(b), c_(c), edges_{difference(a, b), difference(a, c)} {}

  /// The orientation of the three points and d, if the filter is certain.
  [[nodiscard]] std::optional<int> certain_side(const MovedPoint<3>& d) const noexcept {
    const auto& [p, q] = edges_;
    const Point<3> r = difference(a_, d);
    const double error = a_.move->error;
    const double size = largest_of<3, 3>({p, q, r}) + error;
    const double value = ((p[1] * q[2] - p[2] * q[1]) * r[0] + (p[2] * q[0] - p[0] * q[2]) * r[1]) +
                         (p[0] * q[1] - p[1] * q[0]) * r[2];
    const double band = size * size * (band_of_moved * size + errors_of_moved * error);
    if (!(is_safe_difference(size) && std::fabs(value) > band)) return {};
    return value < 0.0 ? -1 : 1;
  }

  /// The orientation of the three points and d. Adds one to `exact_decisions` when arithmetic
  /// without rounding must decide.
  [[nodiscard]] int side(const MovedPoint<3>& d, std::uint64_t& exact_decisions) const noexcept {
    if (const auto certain = certain_side(d)) return *certain;
    if (d == a_ || d == b_ || d == c_) return 0;
    ++exact_decisions;
    return orientation_exactly(a_, b_, c_, d);
  }

 private:
  MovedPoint<3> a_, b_, c_;
  std::array<Point<3>, 2> edges_;  ///< b - a, c - a
};

}  // namespace abut::exact
