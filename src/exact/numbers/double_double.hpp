#pragma once

#include "base/host_device.hpp"

#include <limits>

namespace abut::exact {

inline constexpr double largest_double = std::numeric_limits<double>::max();

/// The largest number that neither overflows nor loses bits where it is split for an exact product
/// with an integer of 32 bits, nor in a sum of such products.
inline constexpr double largest_summed = 0x1p900;

/// high + low, exactly.
struct DoubleDouble {
  double high;
  double low;
};

/// a + b (D. E. Knuth, The Art of Computer Programming, volume 2, 4.2.2, theorem B).
ABUT_HD inline DoubleDouble two_sum(double a, double b) noexcept {
  const double sum = a + b;
  const double b_seen = sum - a;
  return {sum, (a - (sum - b_seen)) + (b - b_seen)};
}

namespace detail {

/// A number as the sum of two of at most 26 bits (T. J. Dekker, A floating-point technique for
/// extending the available precision, Numer. Math. 18 (1971) 224-242).
ABUT_HD inline DoubleDouble halves(double value) noexcept {
  const double scaled = 134217729.0 * value;  // 2^27 + 1
  const double high = scaled - (scaled - value);
  return {high, value - high};
}

}  // namespace detail

/// a * b (Dekker, as above), where nothing over- or underflows.
ABUT_HD inline DoubleDouble two_product(double a, double b) noexcept {
  const DoubleDouble p = detail::halves(a);
  const DoubleDouble q = detail::halves(b);
  const double product = a * b;
  const double crossed = (p.high * q.high - product) + p.high * q.low + p.low * q.high;
  return {product, crossed + p.low * q.low};
}

/// value * value, for 2^-480 <= |value| <= 2^480.
ABUT_HD inline DoubleDouble two_square(double value) noexcept {
  const DoubleDouble p = detail::halves(value);
  const double square = value * value;
  return {square, ((p.high * p.high - square) + 2.0 * p.high * p.low) + p.low * p.low};
}

/// (high + low)^2 but for a relative error of 2^-103, if |low| <= u |high|.
ABUT_HD inline DoubleDouble square(const DoubleDouble& value) noexcept {
  const DoubleDouble square = two_square(value.high);
  return {square.high, square.low + 2.0 * value.high * value.low};
}

/// A sum of doubles in doubled precision: the rounding error of each addition is exact, and summed
/// apart.
class CompensatedSum {
 public:
  ABUT_HD void add(double term) noexcept {
    const DoubleDouble sum = two_sum(high_, term);
    high_ = sum.high;
    low_ += sum.low;
    rounded_ = rounded_ || sum.low != 0.0;
  }
  ABUT_HD void add(const DoubleDouble& term) noexcept {
    add(term.high);
    add(term.low);
  }

  [[nodiscard]] ABUT_HD DoubleDouble value() const noexcept { return two_sum(high_, low_); }

  /// Tells whether some addition rounded, or left the range of finite numbers.
  [[nodiscard]] ABUT_HD bool rounded() const noexcept { return rounded_; }

 private:
  double high_ = 0.0;
  double low_ = 0.0;
  bool rounded_ = false;
};

}  // namespace abut::exact
