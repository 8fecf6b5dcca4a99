#pragma once

// The gap of a sphere and an image of another, for both processors.

#include "base/host_device.hpp"
#include "exact/cancellation.hpp"
#include "exact/center_vector.hpp"
#include "exact/image_difference.hpp"
#include "exact/periodic_gap.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/sphere_gap-inl.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::exact {

/// x_a - (x_b + n A), times a power of two. Errs by less than 2^-54 of its largest component.
template <int Dim>
class ScaledDifference {
 public:
  /// By compensated sums. False where numbers are too large for these, or cancel too far.
  [[nodiscard]] ABUT_HD bool sum_in_doubles(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                            const LatticeSteps<Dim>& steps) noexcept {
    const double terms = begin(a, b, steps);
    if (!are_small(terms)) return false;
    double longest = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      longest = std::max(longest, set(axis, image_difference(a, b, steps, axis).value().high));
    }
    return longest >= most_cancellation * terms;
  }

  /// Each component rounded once, for numbers of any size.
  ABUT_HD void sum_exactly(const Sphere<Dim>& a, const Sphere<Dim>& b,
                           const LatticeSteps<Dim>& steps) noexcept {
    if (are_small(begin(a, b, steps))) {
      for (int axis = 0; axis < Dim; ++axis) set(axis, -component(a, b, steps, axis).high);
      return;
    }
    for (int axis = 0; axis < Dim; ++axis) set(axis, rounded_difference(a, b, steps, axis));
    if (largest_ <= largest_summed) return;
    // Beside a number that large, what scaling loses of the others is of no account.
    scale_ = scale_of_large;
    largest_ = std::max(a.radius, b.radius) * scale_;
    for (int axis = 0; axis < Dim; ++axis) {
      set(axis, -component(a, b, steps, axis, scale_).high);
    }
  }

  /// Its length without the radii, as it is computed: only the sign may be wrong.
  [[nodiscard]] ABUT_HD double gap(double radius_a, double radius_b) const noexcept {
    const double scale = detail::scale_of_squares(largest_);
    double distance_squared = 0.0;
    for (const double component : component_) {
      distance_squared += (component * scale) * (component * scale);
    }
    const double radii = radius_a * scale_ * scale + radius_b * scale_ * scale;
    return detail::made_finite((std::sqrt(distance_squared) - radii) / scale / scale_);
  }

 private:
  /// Brings differences and radii that exceed this bound to where their squares can be scaled.
  static constexpr double scale_of_large = 0x1p-128;

  /// Returns the largest of all that is added up.
  ABUT_HD double begin(const Sphere<Dim>& a, const Sphere<Dim>& b,
                       const LatticeSteps<Dim>& steps) noexcept {
    largest_ = std::max(a.radius, b.radius);
    return largest_term(a, b, steps);
  }

  [[nodiscard]] ABUT_HD bool are_small(double terms) const noexcept {
    return std::max(terms, largest_) <= largest_summed;
  }

  /// Returns the magnitude.
  ABUT_HD double set(int axis, double value) noexcept {
    component_[axis] = value;
    largest_ = std::max(largest_, std::fabs(value));
    return std::fabs(value);
  }

  double component_[Dim] = {};
  double scale_ = 1.0;
  double largest_ = 0.0;  ///< of the components and the radii, times the scale
};

template <int Dim>
ABUT_HD double gap(const Sphere<Dim>& a, const Sphere<Dim>& b, const ImageShift& shift,
                   const Lattice& lattice) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  if (steps.empty()) return gap(a, b);
  ScaledDifference<Dim> difference;
  if (!difference.sum_in_doubles(a, b, steps)) difference.sum_exactly(a, b, steps);
  std::uint64_t exact_decisions = 0;
  const bool touch = within_reach(a, b, shift, lattice, 0.0, exact_decisions);
  return gap_of_sign(difference.gap(a.radius, b.radius), touch);
}

}  // namespace abut::exact
