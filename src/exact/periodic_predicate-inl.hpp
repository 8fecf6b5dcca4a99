#pragma once

// The slow path of the contract with a lattice (docs/derivations/periodic_predicate.md), for both
// processors.

#include "base/host_device.hpp"
#include "exact/image_difference.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/periodic_stages.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace abut::exact {

template <int Dim>
ABUT_HD std::optional<bool> decide_if_difference_is_exact(const Sphere<Dim>& a,
                                                          const Sphere<Dim>& b,
                                                          const LatticeSteps<Dim>& steps,
                                                          double margin) noexcept {
  Sphere<Dim> at_difference{{}, a.radius};
  const Sphere<Dim> at_origin{{}, b.radius};
  for (int axis = 0; axis < Dim; ++axis) {
    const CompensatedSum difference = image_difference(a, b, steps, axis);
    if (difference.rounded()) return std::nullopt;
    at_difference.center[axis] = difference.value().high;
  }
  return within_reach_exactly(at_difference, at_origin, margin);
}

namespace detail {

/// The sum of the magnitudes of all numbers that distance and reach are made of, nearly.
template <int Dim>
[[nodiscard]] ABUT_HD double magnitude_of(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                          const LatticeSteps<Dim>& steps, double margin) noexcept {
  double magnitude = a.radius + b.radius + margin;
  for (int axis = 0; axis < Dim; ++axis) {
    magnitude += std::fabs(a.center[axis]) + std::fabs(b.center[axis]);
    for (const auto& step : steps) magnitude += std::fabs(step.number * step.vector[axis]);
  }
  return magnitude;
}

}  // namespace detail

// THE ERROR. m is the sum of all magnitudes, t the reach and the components of the difference
// together. A component is a sum of at most eight doubles; what compensation leaves is below
// 50 u^2 of their magnitudes (T. Ogita, S. M. Rump and S. Oishi, Accurate sum and dot product,
// SIAM J. Sci. Comput. 26 (2005) 1955-1988, Prop. 4.5), on all axes together below 2^-100 m. Its
// square is off by 2^-99 m times the component, and 2^-200 m^2; the squares themselves and their
// sum by 2^-98 t^2, where t < 1.01 m. All this is below 2^-96 m t + 2^-200 m^2, and what underflows
// below 2^-1060. A difference larger than the tolerance 2^-95 m (t + 2^-90 m) >= 2^-985 is thus
// real.
template <int Dim>
ABUT_HD std::optional<bool> decide_in_double_double(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                    const LatticeSteps<Dim>& steps,
                                                    double margin) noexcept {
  const double magnitude = detail::magnitude_of(a, b, steps, margin);
  if (!(magnitude >= 0x1p-400 && magnitude <= 0x1p400)) return std::nullopt;
  const DoubleDouble radii = two_sum(a.radius, b.radius);
  const DoubleDouble with_margin = two_sum(radii.high, margin);
  const DoubleDouble reach = two_sum(with_margin.high, with_margin.low + radii.low);
  const DoubleDouble reach_squared = square(reach);
  double high = -reach_squared.high;
  double low = -reach_squared.low;
  double together = reach.high;
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDouble difference = image_difference(a, b, steps, axis).value();
    together += std::fabs(difference.high);
    const DoubleDouble term = square(difference);
    const DoubleDouble sum = two_sum(high, term.high);
    high = sum.high;
    low += sum.low + term.low;
  }
  const double excess = high + low;
  const double tolerance = 0x1p-95 * magnitude * (together + 0x1p-90 * magnitude);
  if (!(std::fabs(excess) > tolerance)) return std::nullopt;
  return excess < 0.0;
}

namespace detail {

/// Some doubles, each with an integer factor; their sum is never formed, only its square.
struct Terms {
  struct Term {
    double value;
    std::int64_t factor;
  };

  ABUT_HD void add(double value, std::int64_t factor) noexcept { terms[count++] = {value, factor}; }

  ABUT_HD void subtract_square_from(ExactAccumulator<2>& sum) const noexcept {
    // Twice the product of two factors might exceed 63 bits: each mixed product is taken twice.
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        sum.add_product(terms[i].value, terms[j].value, -terms[i].factor * terms[j].factor);
      }
    }
  }

  std::array<Term, 5> terms{};
  std::size_t count = 0;
};

}  // namespace detail

/// Sign of (r_a + r_b + m)^2 - |a - b - n A|^2, expanded into products of inputs and of shifts, of
/// which two make at most 2^62.
template <int Dim>
ABUT_HD bool decide_accumulated(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                const LatticeSteps<Dim>& steps, double margin) noexcept {
  ExactAccumulator<2> slack;
  for (int axis = 0; axis < Dim; ++axis) {
    detail::Terms difference;
    difference.add(a.center[axis], 1);
    difference.add(b.center[axis], -1);
    for (const auto& step : steps) difference.add(step.vector[axis], -std::int64_t{step.number});
    difference.subtract_square_from(slack);
  }
  const std::array<double, 3> reach{a.radius, b.radius, margin};
  for (const double p : reach) {
    for (const double q : reach) slack.add_product(p, q, 1);
  }
  return slack.sign() >= 0;
}

template <int Dim>
ABUT_HD bool within_reach_exactly(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                  const LatticeSteps<Dim>& steps, double margin) noexcept {
  if (const auto decided = decide_if_difference_is_exact(a, b, steps, margin)) return *decided;
  if (const auto decided = decide_in_double_double(a, b, steps, margin)) return *decided;
  return decide_accumulated(a, b, steps, margin);
}

}  // namespace abut::exact
