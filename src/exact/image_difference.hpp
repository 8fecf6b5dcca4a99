#pragma once

#include "base/host_device.hpp"
#include "exact/lattice.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/sphere.hpp"

#include <cstdint>

namespace abut::exact {

/// One component of x_a - x_b - n A, each number times a power of two `scale`. Exchanging a and b
/// and negating n negates it, to the bit. Products of an integer and a double lose nothing by
/// underflow: all are multiples of the last bit of the double.
template <int Dim>
[[nodiscard]] ABUT_HD CompensatedSum image_difference(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                      const LatticeSteps<Dim>& steps, int axis,
                                                      double scale = 1.0) noexcept {
  CompensatedSum difference;
  difference.add(a.center[axis] * scale);
  difference.add(-b.center[axis] * scale);
  for (const auto& step : steps) {
    difference.add(two_product(-static_cast<double>(step.number), step.vector[axis] * scale));
  }
  return difference;
}

/// Returns that component for numbers of any size, rounded once; infinite beyond the largest
/// double.
template <int Dim>
[[nodiscard]] ABUT_HD double rounded_difference(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                const LatticeSteps<Dim>& steps, int axis) noexcept {
  ExactAccumulator<1> sum;
  sum.add(a.center[axis], 1);
  sum.add(b.center[axis], -1);
  for (const auto& step : steps) sum.add(step.vector[axis], -std::int64_t{step.number});
  return sum.rounded();
}

}  // namespace abut::exact
