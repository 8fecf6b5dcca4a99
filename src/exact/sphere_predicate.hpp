#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"

#include <cstdint>

namespace abut::exact {

/// The slow path: whether |a - b|^2 <= (r_a + r_b + margin)^2 in real arithmetic, for every finite
/// double. Needs the default floating-point environment, as the whole library does.
template <int Dim>
[[nodiscard]] ABUT_HD bool within_reach_exactly(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                double margin) noexcept;

// The band of the filter. With u = 2^-53, D and S the real distance and reach, d2 and s2 their
// computed squares, and s2 in [2^-960, 2^1000]:
//   d2 < s2 (1 - 16 u)  implies  D^2 < S^2,
//   d2 > s2 (1 + 16 u)  implies  D^2 > S^2, also where d2 overflows.
// Between them, and for other s2, the filter abstains. The proof is
// docs/derivations/predicate_band.md.
inline constexpr double band = 0x1p-49;  // 16 u
inline constexpr double smallest_safe_square = 0x1p-960;
inline constexpr double largest_safe_square = 0x1p1000;

/// The one function that decides the contract of docs/contract.md. Touching counts. Adds one to
/// `exact_decisions` when the filter cannot decide.
template <int Dim>
[[nodiscard]] ABUT_HD inline bool within_reach(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                               double margin,
                                               std::uint64_t& exact_decisions) noexcept {
  double difference = a.center[0] - b.center[0];
  double distance_squared = difference * difference;
  for (int axis = 1; axis < Dim; ++axis) {
    difference = a.center[axis] - b.center[axis];
    distance_squared += difference * difference;
  }
  const double reach = a.radius + b.radius + margin;
  const double reach_squared = reach * reach;
  if (reach_squared >= smallest_safe_square && reach_squared <= largest_safe_square) {
    if (distance_squared > reach_squared * (1.0 + band)) return false;
    if (distance_squared < reach_squared * (1.0 - band)) return true;
  }
  ++exact_decisions;
  return within_reach_exactly(a, b, margin);
}

}  // namespace abut::exact
