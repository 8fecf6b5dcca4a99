#pragma once

#include "base/host_device.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere_predicate.hpp"

#include <cmath>
#include <cstdint>

namespace abut::exact {

/// The slow path: whether |x_a - (x_b + n A)|^2 <= (r_a + r_b + margin)^2 in real arithmetic, for
/// every finite double and every shift n of a lattice A.
template <int Dim>
[[nodiscard]] ABUT_HD bool within_reach_exactly(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                const LatticeSteps<Dim>& steps,
                                                double margin) noexcept;

// THE BAND IS ABSOLUTE: x_a and x_b + n A may be large and almost equal. u = 2^-53, D and S the
// real distance and reach, m the sum of the magnitudes of all that is added up: coordinates,
// n_k A_k on every axis, radii, margin. On one axis the products are rounded by u |n_k A_k|
// together, and each of at most four additions by u times what has been added so far: each
// component is off by less than 5.01 u of its magnitudes, and the distance by no more than the
// components together, 5.01 u m. Three more roundings in its square are 1.51 u of its root; the
// reach is off by 2.01 u S. With e = 8 u m, as computed above 7.99 u m,
//   d2 > (s + e)^2  implies  D > (S + e)(1 - 1.52 u) - (2.01 S + 1.51 D~ + 5.01 m) u > S,
//   d2 < (s - e)^2  implies  D < S likewise, if s > e.
// Inside [2^-400, 2^500] no sum or product overflows, and what squares lose by underflow, 2^-537 of
// a root, is far below e. docs/derivations/periodic_predicate.md tells it at length.
inline constexpr double absolute_band = 0x1p-50;  // 8 u
inline constexpr double smallest_safe_magnitude = 0x1p-400;
inline constexpr double largest_safe_magnitude = 0x1p500;

/// The contract with a lattice: whether a and the image of b that `shift` names are within reach.
/// Touching counts. Adds one to `exact_decisions` when the filter cannot decide.
template <int Dim>
[[nodiscard]] ABUT_HD inline bool within_reach(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                               const ImageShift& shift, const Lattice& lattice,
                                               double margin,
                                               std::uint64_t& exact_decisions) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  if (steps.empty()) return within_reach(a, b, margin, exact_decisions);
  const double reach = a.radius + b.radius + margin;
  double magnitude = reach;
  double distance_squared = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    double difference = a.center[axis] - b.center[axis];
    magnitude += std::fabs(a.center[axis]) + std::fabs(b.center[axis]);
    for (const auto& step : steps) {
      const double product = step.number * step.vector[axis];
      difference -= product;
      magnitude += std::fabs(product);
    }
    distance_squared += difference * difference;
  }
  if (magnitude >= smallest_safe_magnitude && magnitude <= largest_safe_magnitude) {
    const double slack = absolute_band * magnitude;
    const double outer = reach + slack;
    const double inner = reach - slack;
    if (distance_squared > outer * outer) return false;
    if (inner > 0.0 && distance_squared < inner * inner) return true;
  }
  ++exact_decisions;
  return within_reach_exactly(a, b, steps, margin);
}

}  // namespace abut::exact
