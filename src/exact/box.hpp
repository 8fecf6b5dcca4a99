#pragma once

#include "base/host_device.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::exact {

/// A closed axis-aligned box as the library works with it: finite numbers, lower <= upper.
template <int Dim>
struct Box {
  double lower[Dim];
  double upper[Dim];
};

/// True if a - b <= rounded in real arithmetic, where `rounded` is the computed difference.
///
/// The part that rounding took away, from the operand of larger magnitude (T. J. Dekker, A
/// Floating-Point Technique for Extending the Available Precision, Numer. Math. 18, 1971, p. 224,
/// section 4): no step of it rounds, nor can it overflow.
[[nodiscard]] ABUT_HD inline bool difference_rounds_up(double a, double b,
                                                       double rounded) noexcept {
  const bool a_is_larger = !(std::fabs(a) < std::fabs(b));
  const double large = a_is_larger ? a : -b;
  const double small = a_is_larger ? -b : a;
  const double lost = small - (rounded - large);
  return lost <= 0.0;
}

/// True if a <= b + margin in real arithmetic, for all finite doubles. A rounded difference that is
/// not equal to the margin lies on the right side of it; an equal one is looked at again.
[[nodiscard]] ABUT_HD inline bool at_most(double a, double b, double margin,
                                          std::uint64_t& exact_decisions) noexcept {
  if (margin == 0.0) return a <= b;
  const double difference = a - b;
  if (difference != margin) return difference < margin;
  ++exact_decisions;
  return difference_rounds_up(a, b, difference);
}

/// The contract for boxes (docs/contract.md): on every axis lo_a <= hi_b + margin and
/// lo_b <= hi_a + margin. Touching counts. Adds at most one to `exact_decisions`, as the spheres'
/// predicate does.
template <int Dim>
[[nodiscard]] ABUT_HD inline bool within_reach(const Box<Dim>& a, const Box<Dim>& b, double margin,
                                               std::uint64_t& exact_decisions) noexcept {
  std::uint64_t looked_at_again = 0;
  bool within = true;
  for (int axis = 0; within && axis < Dim; ++axis) {
    within = at_most(a.lower[axis], b.upper[axis], margin, looked_at_again) &&
             at_most(b.lower[axis], a.upper[axis], margin, looked_at_again);
  }
  exact_decisions += looked_at_again > 0 ? 1 : 0;
  return within;
}

/// The largest separation of two boxes over the axes: lower end minus upper end, rounded once, and
/// so of the right sign; <= 0 exactly if they touch. What exceeds the largest double is that.
template <int Dim>
[[nodiscard]] ABUT_HD inline double gap(const Box<Dim>& a, const Box<Dim>& b) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  double result = -largest;
  for (int axis = 0; axis < Dim; ++axis) {
    result = std::max(result, a.lower[axis] - b.upper[axis]);
    result = std::max(result, b.lower[axis] - a.upper[axis]);
  }
  // Adding 0 makes -0 a 0: max may return either of two zeros.
  return std::min(result, largest) + 0.0;
}

}  // namespace abut::exact
