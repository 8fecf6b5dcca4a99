#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

/// Functions that scenes compute with beyond + - x /: only operations that IEEE 754 rounds
/// correctly, so that the bits are equal on every machine. std::sqrt is one, std::cbrt, std::pow
/// and std::exp are not.
namespace abut::scenes {

inline constexpr double pi = 0x1.921fb54442d18p+1;

/// Newton's iteration, always the same number of steps. For 1e-9 < value < 1e30.
[[nodiscard]] inline double cube_root(double value) noexcept {
  double power_of_eight = 1.0;
  double root = 1.0;  // cube root of power_of_eight
  while (power_of_eight > value) power_of_eight *= 0.125, root *= 0.5;
  while (power_of_eight * 8.0 <= value) power_of_eight *= 8.0, root *= 2.0;
  for (int step = 0; step < 8; ++step) {
    root = (2.0 * root + value / (root * root)) * (1.0 / 3.0);
  }
  return root;
}

/// base^exponent for 0 <= exponent < 1: a product of repeated square roots, one for each bit of
/// the exponent that is set.
[[nodiscard]] inline double fractional_power(double base, double exponent) noexcept {
  double power = 1.0;
  double root = base;
  for (int bit = 0; bit < 40; ++bit) {
    root = std::sqrt(root);
    exponent *= 2.0;
    if (exponent >= 1.0) {
      power *= root;
      exponent -= 1.0;
    }
  }
  return power;
}

/// The number `steps` representable numbers above `value` (below, if negative) for value > 0 and
/// small steps: the bit patterns of positive numbers are in the order of the numbers.
template <class Real, class Bits>
[[nodiscard]] Real stepped(Real value, int steps) noexcept {
  return std::bit_cast<Real>(std::bit_cast<Bits>(value) + static_cast<Bits>(steps));
}
[[nodiscard]] inline double neighbor_number(double value, int steps) noexcept {
  return stepped<double, std::uint64_t>(value, steps);
}
[[nodiscard]] inline float neighbor_number(float value, int steps) noexcept {
  return stepped<float, std::uint32_t>(value, steps);
}

}  // namespace abut::scenes
