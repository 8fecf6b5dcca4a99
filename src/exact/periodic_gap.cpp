#include "exact/periodic_gap.hpp"

#include "exact/cancellation.hpp"
#include "exact/center_vector.hpp"
#include "exact/image_difference.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/sphere_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::exact {
namespace {

/// The largest number whose sums and products by a shift neither overflow nor lose bits in Dekker's
/// splitting: n A is below 2^1055.
constexpr double largest_summed = 0x1p900;

/// Brings differences and radii that exceed this bound to where their squares can be scaled.
constexpr double scale_of_large = 0x1p-128;

/// x_a - (x_b + n A), times a power of two. Errs by less than 2^-54 of its largest component.
template <int Dim>
struct ScaledDifference {
  ScaledDifference(const Sphere<Dim>& a, const Sphere<Dim>& b,
                   const LatticeSteps<Dim>& steps) noexcept
      : largest(std::max(a.radius, b.radius)) {
    const double terms = largest_term(a, b, steps);
    if (!(std::max(terms, largest) <= largest_summed)) {
      subtract_large(a, b, steps);
      return;
    }
    double longest = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      longest = std::max(longest, set(axis, image_difference(a, b, steps, axis).value().high));
    }
    if (longest >= most_cancellation * terms) return;
    largest = std::max(a.radius, b.radius);
    for (int axis = 0; axis < Dim; ++axis) set(axis, -component_between(a, b, steps, axis));
  }

  double component[Dim] = {};
  double scale = 1.0;
  double largest;  ///< of the components and the radii, times the scale

 private:
  /// Returns the magnitude.
  double set(int axis, double value) noexcept {
    component[axis] = value;
    largest = std::max(largest, std::fabs(value));
    return std::fabs(value);
  }

  static double component_between(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                  const LatticeSteps<Dim>& steps, int axis,
                                  double times = 1.0) noexcept {
    return exact::component(a, b, steps, axis, times).high;
  }

  void subtract_large(const Sphere<Dim>& a, const Sphere<Dim>& b,
                      const LatticeSteps<Dim>& steps) noexcept {
    for (int axis = 0; axis < Dim; ++axis) set(axis, rounded_difference(a, b, steps, axis));
    if (largest <= largest_summed) return;
    // Beside a number that large, what scaling loses of the others is of no account.
    scale = scale_of_large;
    largest = std::max(a.radius, b.radius) * scale;
    for (int axis = 0; axis < Dim; ++axis) {
      set(axis, -component_between(a, b, steps, axis, scale));
    }
  }
};

/// A further power of two that brings distance or radii near one where squares would leave the
/// exponent range.
double scale_of_squares(double largest) noexcept {
  if (largest > 0x1p500) return 0x1p-600;
  if (largest < 0x1p-400 && largest > 0.0) return 0x1p600;
  return 1.0;
}

}  // namespace

template <int Dim>
double gap(const Sphere<Dim>& a, const Sphere<Dim>& b, const ImageShift& shift,
           const Lattice& lattice) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  if (steps.empty()) return gap(a, b);
  const ScaledDifference<Dim> difference(a, b, steps);
  const double first_scale = difference.scale;
  const double scale = scale_of_squares(difference.largest);
  double distance_squared = 0.0;
  for (const double component : difference.component) {
    distance_squared += (component * scale) * (component * scale);
  }
  const double radii = a.radius * first_scale * scale + b.radius * first_scale * scale;
  const double computed =
      std::clamp((std::sqrt(distance_squared) - radii) / scale / first_scale,
                 std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());

  std::uint64_t exact_decisions = 0;
  const bool touch = within_reach(a, b, shift, lattice, 0.0, exact_decisions);
  if (touch) return std::min(computed, 0.0) + 0.0;  // never -0.0
  return std::max(computed, std::numeric_limits<double>::denorm_min());
}

template double gap(const Sphere<2>&, const Sphere<2>&, const ImageShift&, const Lattice&) noexcept;
template double gap(const Sphere<3>&, const Sphere<3>&, const ImageShift&, const Lattice&) noexcept;

}  // namespace abut::exact
