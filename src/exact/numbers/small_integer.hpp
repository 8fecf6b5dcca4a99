#pragma once

#include "exact/numbers/bits.hpp"

#include <cmath>

namespace abut::exact {

/// A whole number below 2^127: sums, differences and products of short doubles over a common power
/// of two. Who uses it says how many bits these may have for nothing to overflow.
class SmallInteger {
 public:
  /// value / 2^exponent, which must be a whole number.
  SmallInteger(double value, int exponent) noexcept
      : value_(static_cast<Int128>(std::ldexp(value, -exponent))) {}

  [[nodiscard]] int sign() const noexcept { return (value_ > 0) - (value_ < 0); }

  friend SmallInteger operator+(SmallInteger a, SmallInteger b) noexcept {
    return SmallInteger(a.value_ + b.value_);
  }
  friend SmallInteger operator-(SmallInteger a, SmallInteger b) noexcept {
    return SmallInteger(a.value_ - b.value_);
  }
  friend SmallInteger operator*(SmallInteger a, SmallInteger b) noexcept {
    return SmallInteger(a.value_ * b.value_);
  }
  friend bool operator<=(SmallInteger a, SmallInteger b) noexcept { return a.value_ <= b.value_; }

 private:
  explicit SmallInteger(Int128 value) noexcept : value_(value) {}

  Int128 value_;
};

}  // namespace abut::exact
