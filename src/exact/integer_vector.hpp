#pragma once

#include "exact/lattice.hpp"
#include "exact/numbers/big_integer.hpp"
#include "exact/numbers/bit_range.hpp"

namespace abut::exact {

/// A vector of whole numbers: of doubles over a common power of two.
template <class Integer>
struct IntegerVector {
  Integer x, y, z;

  IntegerVector(const double (&point)[3], int exponent) noexcept
      : x(point[0], exponent), y(point[1], exponent), z(point[2], exponent) {}
  IntegerVector(const Integer& x_given, const Integer& y_given, const Integer& z_given) noexcept
      : x(x_given), y(y_given), z(z_given) {}
};

template <class Integer>
[[nodiscard]] IntegerVector<Integer> operator-(const IntegerVector<Integer>& a,
                                               const IntegerVector<Integer>& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Integer>
[[nodiscard]] Integer dot(const IntegerVector<Integer>& a,
                          const IntegerVector<Integer>& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Integer>
[[nodiscard]] IntegerVector<Integer> cross(const IntegerVector<Integer>& a,
                                           const IntegerVector<Integer>& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline void include(BitRange& range, const double (&point)[3]) noexcept {
  for (const double x : point) range.include(x);
}

inline void include(BitRange& range, const LatticeSteps<3>& steps) noexcept {
  for (const auto& step : steps) {
    for (int axis = 0; axis < 3; ++axis) range.include(step.vector[axis]);
  }
}

/// x - n A: what sees a body as x sees it when it is moved by n A.
[[nodiscard]] inline IntegerVector<BigInteger> moved_back(const double (&center)[3],
                                                          const LatticeSteps<3>& steps,
                                                          int exponent) noexcept {
  IntegerVector<BigInteger> moved(center, exponent);
  for (const auto& step : steps) {
    const auto product = [&](int axis) {
      return BigInteger(step.number, 0) * BigInteger(step.vector[axis], exponent);
    };
    moved = moved - IntegerVector<BigInteger>(product(0), product(1), product(2));
  }
  return moved;
}

}  // namespace abut::exact
