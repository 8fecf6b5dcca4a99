#pragma once

#include <cmath>
#include <limits>

namespace abut::benchmarks {

/// The side of a box on one axis.
template <class Real>
struct Bounds {
  Real low;
  Real high;
};

/// The same side in float, so much wider that rounding loses no pair.
[[nodiscard]] inline Bounds<float> float_bounds(const Bounds<double>& side) {
  constexpr float ulp = 0x1p-23F;
  constexpr float least = std::numeric_limits<float>::min();
  const auto low = static_cast<float>(side.low);
  const auto high = static_cast<float>(side.high);
  return {low - std::abs(low) * ulp - least, high + std::abs(high) * ulp + least};
}

}  // namespace abut::benchmarks
