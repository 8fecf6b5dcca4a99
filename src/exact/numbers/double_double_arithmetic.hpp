#pragma once

#include "exact/numbers/double_double.hpp"

#include <cmath>

namespace abut::exact {

// Sums and products of pairs high + low with |low| <= u |high|, u = 2^-53; where nothing over- or
// underflows. (T. J. Dekker, A floating-point technique for extending the available precision,
// Numer. Math. 18 (1971) 224-242.)

/// a + b, for |a| >= |b| or a = 0.
[[nodiscard]] inline DoubleDouble sum_of_ordered(double a, double b) noexcept {
  const double high = a + b;
  return {high, b - (high - a)};
}

/// a + b but for 2^-104 (|a| + |b|).
[[nodiscard]] inline DoubleDouble sum(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = two_sum(a.high, b.high);
  return sum_of_ordered(high.high, high.low + (a.low + b.low));
}

[[nodiscard]] inline DoubleDouble opposite(const DoubleDouble& a) noexcept {
  return {-a.high, -a.low};
}

/// a - b but for 2^-104 (|a| + |b|).
[[nodiscard]] inline DoubleDouble difference(const DoubleDouble& a,
                                             const DoubleDouble& b) noexcept {
  return sum(a, opposite(b));
}

/// a b but for 2^-103 |a b|.
[[nodiscard]] inline DoubleDouble product(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const DoubleDouble high = two_product(a.high, b.high);
  return sum_of_ordered(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/// a / b but for 2^-100 |a / b|.
[[nodiscard]] inline DoubleDouble quotient(const DoubleDouble& a, const DoubleDouble& b) noexcept {
  const double first = a.high / b.high;
  const DoubleDouble back = two_product(first, b.high);
  const double left = ((a.high - back.high) - back.low) + (a.low - first * b.low);
  return sum_of_ordered(first, left / b.high);
}

/// The square root of a number that is not negative, but for 2^-100 of itself.
[[nodiscard]] inline DoubleDouble square_root(const DoubleDouble& a) noexcept {
  if (a.high == 0.0) return {0.0, 0.0};
  const double root = std::sqrt(a.high);
  const DoubleDouble back = two_square(root);
  return sum_of_ordered(root, (((a.high - back.high) - back.low) + a.low) / (2.0 * root));
}

/// A vector in doubled precision.
struct DoubleDoubleVector {
  DoubleDouble component[3]{};
};

/// Returns a x b, but for an error of 2^-101 of the product of the largest components, on each
/// axis.
[[nodiscard]] inline DoubleDoubleVector cross(const DoubleDoubleVector& a,
                                              const DoubleDoubleVector& b) noexcept {
  const auto along = [&](int axis) {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    return difference(product(a.component[next], b.component[last]),
                      product(a.component[last], b.component[next]));
  };
  return {{along(0), along(1), along(2)}};
}

/// Returns a · b, but for an error of 2^-100 of the product of the largest components.
[[nodiscard]] inline DoubleDouble dot(const DoubleDoubleVector& a,
                                      const DoubleDoubleVector& b) noexcept {
  return sum(sum(product(a.component[0], b.component[0]), product(a.component[1], b.component[1])),
             product(a.component[2], b.component[2]));
}

}  // namespace abut::exact
