#pragma once

#include "exact/numbers/big_integer.hpp"
#include "exact/numbers/double_double.hpp"

namespace abut::exact {

/// A number of any size in doubled precision: value 2^exponent, where |value| is in [1/2, 4) or 0.
/// Operations err by less than 2^-98 of their result.
class ScaledNumber {
 public:
  /// value 2^exponent, for ordinary numbers.
  explicit ScaledNumber(const DoubleDouble& value = {0.0, 0.0}, int exponent = 0) noexcept;
  /// integer 2^exponent
  ScaledNumber(const BigInteger& integer, int exponent) noexcept;

  friend ScaledNumber operator*(const ScaledNumber& a, const ScaledNumber& b) noexcept;
  friend ScaledNumber operator/(const ScaledNumber& a, const ScaledNumber& b) noexcept;
  /// Adds two numbers that are not negative.
  friend ScaledNumber operator+(const ScaledNumber& a, const ScaledNumber& b) noexcept;
  /// Returns the square root of a number that is not negative.
  [[nodiscard]] ScaledNumber root() const noexcept;

  /// The number times 2^-exponent, as a pair; what is too small for a double is 0.
  [[nodiscard]] DoubleDouble over(int exponent) const noexcept;

  /// Such that the number is 0 or its magnitude in [1/2, 4) times two to this power.
  [[nodiscard]] int exponent() const noexcept { return exponent_; }

  /// Rounded; what exceeds the largest double is that. Never -0.0.
  [[nodiscard]] double rounded() const noexcept;

 private:
  DoubleDouble value_;
  int exponent_;
};

}  // namespace abut::exact
