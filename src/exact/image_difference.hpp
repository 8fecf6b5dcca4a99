#pragma once

#include "exact/lattice.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/sphere.hpp"

namespace abut::exact {

/// One component of x_a - x_b - n A, each number times a power of two `scale`. Exchanging a and b
/// and negating n negates it, to the bit. Products of an integer and a double lose nothing by
/// underflow: all are multiples of the last bit of the double.
template <int Dim>
[[nodiscard]] CompensatedSum image_difference(const Sphere<Dim>& a, const Sphere<Dim>& b,
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

}  // namespace abut::exact
