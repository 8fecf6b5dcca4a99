#pragma once

#include "base/host_device.hpp"
#include "exact/lattice.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/numbers/exact_sum.hpp"
#include "exact/sphere.hpp"

#include <cmath>
#include <cstdint>

namespace abut::exact {

/// One component of x_b + n A - x_a, times a power of two: the nearest double and, from what is
/// left, the nearest double. For numbers up to 2^900, which can be split for exact products.
template <int Dim>
[[nodiscard]] ABUT_HD DoubleDouble component(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                             const LatticeSteps<Dim>& steps, int axis,
                                             double scale = 1.0) noexcept {
  const double from = a.center[axis] * scale;
  const double to = b.center[axis] * scale;
  if (steps.empty()) return two_sum(to, -from);
  ExactSum<9> sum;
  sum.add(to);
  sum.add(-from);
  for (const auto& step : steps) {
    sum.add(two_product(static_cast<double>(step.number), step.vector[axis] * scale));
  }
  const double high = sum.rounded();
  sum.add(-high);
  return {high, sum.rounded()};
}

/// Returns that component for numbers of any size, unscaled. Where it exceeds the largest double,
/// `high` is infinite and `low` is 0.
template <int Dim>
[[nodiscard]] DoubleDouble any_component(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                         const LatticeSteps<Dim>& steps, int axis) noexcept {
  ExactAccumulator<1> sum;
  sum.add(b.center[axis], 1);
  sum.add(a.center[axis], -1);
  for (const auto& step : steps) sum.add(step.vector[axis], std::int64_t{step.number});
  const double high = sum.rounded();
  if (!std::isfinite(high)) return {high, 0.0};
  sum.add(high, -1);
  return {high, sum.rounded()};
}

}  // namespace abut::exact
