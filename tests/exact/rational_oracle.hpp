#pragma once

#include "exact/sphere_predicate.hpp"

#include <gmpxx.h>

/// The contract in rational numbers: no rounding, no overflow, nothing shared with the library.
namespace abut::testing {

template <int Dim>
[[nodiscard]] mpq_class exact_distance_squared(const exact::Sphere<Dim>& a,
                                               const exact::Sphere<Dim>& b) {
  mpq_class sum = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const mpq_class difference = mpq_class(a.center[axis]) - mpq_class(b.center[axis]);
    sum += difference * difference;
  }
  return sum;
}

template <int Dim>
[[nodiscard]] mpq_class exact_reach(const exact::Sphere<Dim>& a, const exact::Sphere<Dim>& b,
                                    double margin) {
  return mpq_class(a.radius) + mpq_class(b.radius) + mpq_class(margin);
}

template <int Dim>
[[nodiscard]] bool within_reach_by_rationals(const exact::Sphere<Dim>& a,
                                             const exact::Sphere<Dim>& b, double margin) {
  const mpq_class reach = exact_reach(a, b, margin);
  return exact_distance_squared(a, b) <= reach * reach;
}

}  // namespace abut::testing
