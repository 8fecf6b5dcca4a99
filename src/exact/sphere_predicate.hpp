#pragma once

#include "exact/sphere.hpp"

#include <cstdint>

namespace abut::exact {

/// The slow path: whether |a - b|^2 <= (r_a + r_b + margin)^2 in real arithmetic, for every finite
/// double. Needs the default floating-point environment, as the whole library does.
template <int Dim>
[[nodiscard]] bool within_reach_exactly(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                        double margin) noexcept;

// THE BAND. u = 2^-53, D and S the real distance and reach, d2 and s2 their computed squares.
// A difference of inputs carries one factor (1 + e), |e| <= u; its square two such factors and one
// more; the sum of three squares at most two more: d2 = D^2 (1 + t), |t| <= (1 + u)^5 - 1 < 5.01 u.
// (Gradual underflow: a difference of doubles is never rounded when it is subnormal, and each
// square loses at most 2^-1075, together less than 2^-110 s2 when s2 >= 2^-960.)
// The reach is two additions of non-negative numbers and one square, the same bound:
// s2 = S^2 (1 + t'), |t'| < 5.01 u. Each product s2 * (1 -+ 16 u) adds one rounding. So
//   d2 < s2 (1 - 16 u)  implies  D^2 < S^2 (1 - 16 u)(1 + 7 u) / (1 - 5.01 u) < S^2,
//   d2 > s2 (1 + 16 u)  implies  D^2 > S^2 likewise.
// If d2 overflows while s2 <= 2^1000, D^2 exceeds 2^1023 and the elements are apart; inputs are
// finite, so no NaN can arise. Outside [2^-960, 2^1000] the filter abstains. docs/contract.md
// tells it at length.
inline constexpr double band = 0x1p-49;  // 16 u
inline constexpr double smallest_safe_square = 0x1p-960;
inline constexpr double largest_safe_square = 0x1p1000;

/// The one function that decides the contract of docs/contract.md. Touching counts. Adds one to
/// `exact_decisions` when the filter cannot decide.
template <int Dim>
[[nodiscard]] inline bool within_reach(const Sphere<Dim>& a, const Sphere<Dim>& b, double margin,
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
