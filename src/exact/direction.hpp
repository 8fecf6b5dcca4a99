#pragma once

#include "exact/numbers/double_double.hpp"

#include <algorithm>
#include <cmath>

namespace abut::exact {

/// The length of a vector and the unit vector along it, in double-double arithmetic.
template <int Dim>
struct Direction {
  double root = 0.0;  ///< the length is root + rest
  double rest = 0.0;
  DoubleDouble unit[Dim]{};  ///< |low| is at most a few units in the last place of high
};

template <int Dim>
[[nodiscard]] double largest_of(const DoubleDouble (&vector)[Dim]) noexcept {
  double largest = 0.0;
  for (const DoubleDouble& component : vector) {
    largest = std::max(largest, std::fabs(component.high));
  }
  return largest;
}

// With s the rounded root of the high part of |v|^2, |v| = s + rest up to 2^-96 |v|
// (distance_vector.cpp). high / |v| = q + (high - q s - q rest + low) / |v|, where q s is an exact
// product; what is divided is below 2^-51, so that 1 / s will do for 1 / |v|.

/// The direction of a vector whose components are 0 or in [2^-400, 2^480], and not all 0.
template <int Dim>
[[nodiscard]] Direction<Dim> direction_of(const DoubleDouble (&vector)[Dim]) noexcept {
  double high = 0.0;
  double low = 0.0;
  for (const DoubleDouble& component : vector) {
    const DoubleDouble term = square(component);
    const DoubleDouble sum = two_sum(high, term.high);
    high = sum.high;
    low += sum.low + term.low;
  }
  Direction<Dim> direction;
  const double root = std::sqrt(high);
  direction.root = root;
  const double inverse = 1.0 / root;
  const DoubleDouble of_root = two_square(root);
  direction.rest = ((high - of_root.high) - of_root.low + low) * (0.5 * inverse);
  for (int axis = 0; axis < Dim; ++axis) {
    const double quotient = vector[axis].high * inverse;
    const DoubleDouble product = two_product(quotient, root);
    const double left = ((vector[axis].high - product.high) - product.low) +
                        (vector[axis].low - quotient * direction.rest);
    direction.unit[axis] = {quotient, left * inverse};
  }
  return direction;
}

/// The power of two that brings a number into [1, 2), as an exponent.
[[nodiscard]] inline int exponent_to_one(double number) noexcept {
  return -std::ilogb(number);
}

template <int Dim>
void scale_by(DoubleDouble (&vector)[Dim], int exponent) noexcept {
  for (DoubleDouble& component : vector) {
    component = {std::ldexp(component.high, exponent), std::ldexp(component.low, exponent)};
  }
}

/// The direction of any vector but 0; `root` and `rest` are those of the vector times a power of
/// two.
template <int Dim>
[[nodiscard]] Direction<Dim> direction_of_any(const DoubleDouble (&vector)[Dim]) noexcept {
  DoubleDouble scaled[Dim];
  std::copy(vector, vector + Dim, scaled);
  scale_by(scaled, exponent_to_one(largest_of(vector)));
  return direction_of(scaled);
}

}  // namespace abut::exact
