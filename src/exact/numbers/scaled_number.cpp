#include "exact/numbers/scaled_number.hpp"

#include "exact/numbers/double_double_arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::exact {

ScaledNumber::ScaledNumber(const DoubleDouble& value, int exponent) noexcept
    : value_(value), exponent_(exponent) {
  if (value.high == 0.0) {
    exponent_ = 0;
    return;
  }
  const int size = std::ilogb(value.high);
  value_ = {std::ldexp(value.high, -size), std::ldexp(value.low, -size)};
  exponent_ += size;
}

ScaledNumber::ScaledNumber(const BigInteger& integer, int exponent) noexcept
    : ScaledNumber(integer.leading().number, 0) {
  if (value_.high != 0.0) exponent_ += integer.leading().exponent + exponent;
}

ScaledNumber operator*(const ScaledNumber& a, const ScaledNumber& b) noexcept {
  return ScaledNumber(product(a.value_, b.value_), a.exponent_ + b.exponent_);
}

ScaledNumber operator/(const ScaledNumber& a, const ScaledNumber& b) noexcept {
  return ScaledNumber(quotient(a.value_, b.value_), a.exponent_ - b.exponent_);
}

ScaledNumber operator+(const ScaledNumber& a, const ScaledNumber& b) noexcept {
  if (a.value_.high == 0.0) return b;
  if (b.value_.high == 0.0) return a;
  const int exponent = std::max(a.exponent_, b.exponent_);
  return ScaledNumber(sum(a.over(exponent), b.over(exponent)), exponent);
}

ScaledNumber ScaledNumber::root() const noexcept {
  const int odd = exponent_ & 1;
  return ScaledNumber(square_root({std::ldexp(value_.high, odd), std::ldexp(value_.low, odd)}),
                      (exponent_ - odd) / 2);
}

DoubleDouble ScaledNumber::over(int exponent) const noexcept {
  const int left = std::clamp(exponent_ - exponent, -4000, 4000);
  return {std::ldexp(value_.high, left), std::ldexp(value_.low, left)};
}

double ScaledNumber::rounded() const noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  const double scaled = std::ldexp(value_.high + value_.low, std::clamp(exponent_, -4000, 4000));
  return std::clamp(scaled, -largest, largest) + 0.0;
}

}  // namespace abut::exact
