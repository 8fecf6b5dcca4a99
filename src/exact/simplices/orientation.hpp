#pragma once

#include "exact/simplices/point.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

// The filters. With u = 2^-53, a computed determinant errs by less than 9 u (5 u in the plane) of
// the sum of the magnitudes of its terms, computed alike, unless a product leaves the range of
// doubles. docs/derivations/orientation.md proves it, and that these limits see it whenever one
// does.
namespace abut::exact {

inline constexpr double band_of_line = 0x1p-50;   // 8 u
inline constexpr double band_of_plane = 0x1p-49;  // 16 u
inline constexpr double smallest_safe_area = 0x1p-960;
inline constexpr double smallest_safe_volume = 0x1p-680;
inline constexpr double largest_safe_offset = 0x1p340;

/// Bits of short numbers in the plane: differences are below 2^62, the determinant below 2^125.
inline constexpr int most_short_bits_of_area = 61;
/// In space: differences are below 2^41, components of vector products below 2^83, the determinant
/// below 3 * 2^124.
inline constexpr int most_short_bits_of_volume = 40;

/// Sign of the determinant |b - a, c - a| in real arithmetic, for all finite doubles: 1 if a, b, c
/// turn to the left, -1 if they turn to the right, 0 if they lie on a line.
[[nodiscard]] int orientation_exactly(const Point<2>& a, const Point<2>& b,
                                      const Point<2>& c) noexcept;

/// Sign of the determinant |b - a, c - a, d - a| in real arithmetic, for all finite doubles: 0 if
/// the four points lie in a plane.
[[nodiscard]] int orientation_exactly(const Point<3>& a, const Point<3>& b, const Point<3>& c,
                                      const Point<3>& d) noexcept;

/// What points are seen from: a line through two points in the plane, a plane through three in
/// space. Which side is which follows from the order of these points. Points that coincide or lie
/// on a line are allowed; from them, all others are seen on no side.
template <class P>
class Hyperplane;

template <>
class Hyperplane<Point<2>> {
 public:
  Hyperplane(const Point<2>& a, const Point<2>& b) noexcept
      : a_(a), b_(b), x_(b[0] - a[0]), y_(b[1] - a[1]) {}

  /// The orientation of the two points and c, if the filter is certain.
  [[nodiscard]] std::optional<int> certain_side(const Point<2>& c) const noexcept {
    const double left = x_ * (c[1] - a_[1]);
    const double right = y_ * (c[0] - a_[0]);
    const double value = left - right;
    const double size = std::fabs(left) + std::fabs(right);
    if (!(size >= smallest_safe_area && std::fabs(value) > band_of_line * size)) return {};
    return value < 0.0 ? -1 : 1;
  }

  /// The orientation of the two points and c. Adds one to `exact_decisions` when arithmetic
  /// without rounding must decide.
  [[nodiscard]] int side(const Point<2>& c, std::uint64_t& exact_decisions) const noexcept {
    if (const auto certain = certain_side(c)) return *certain;
    if (c == a_ || c == b_) return 0;
    ++exact_decisions;
    return orientation_exactly(a_, b_, c);
  }

 private:
  Point<2> a_, b_;
  double x_, y_;  ///< of b - a
};

template <>
class Hyperplane<Point<3>> {
 public:
  Hyperplane(const Point<3>& a, const Point<3>& b, const Point<3>& c) noexcept
      : a_(a), b_(b), c_(c) {
    const Point<3> p{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const Point<3> q{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double plus = p[(axis + 1) % 3] * q[(axis + 2) % 3];
      const double minus = p[(axis + 2) % 3] * q[(axis + 1) % 3];
      normal_[axis] = plus - minus;
      size_[axis] = std::fabs(plus) + std::fabs(minus);
    }
  }

  /// The orientation of the three points and d, if the filter is certain.
  [[nodiscard]] std::optional<int> certain_side(const Point<3>& d) const noexcept {
    const double x = d[0] - a_[0], y = d[1] - a_[1], z = d[2] - a_[2];
    const double value = (normal_[0] * x + normal_[1] * y) + normal_[2] * z;
    const double size =
        (size_[0] * std::fabs(x) + size_[1] * std::fabs(y)) + size_[2] * std::fabs(z);
    const double offset = (std::fabs(x) + std::fabs(y)) + std::fabs(z);
    if (!(size >= smallest_safe_volume && offset <= largest_safe_offset &&
          std::fabs(value) > band_of_plane * size)) {
      return {};
    }
    return value < 0.0 ? -1 : 1;
  }

  /// The orientation of the three points and d. Adds one to `exact_decisions` when arithmetic
  /// without rounding must decide.
  [[nodiscard]] int side(const Point<3>& d, std::uint64_t& exact_decisions) const noexcept {
    if (const auto certain = certain_side(d)) return *certain;
    if (d == a_ || d == b_ || d == c_) return 0;
    ++exact_decisions;
    return orientation_exactly(a_, b_, c_, d);
  }

 private:
  Point<3> a_, b_, c_;
  Point<3> normal_;  ///< of the plane: (b - a) x (c - a)
  Point<3> size_;    ///< sums of the magnitudes that each component of it is the difference of
};

}  // namespace abut::exact
