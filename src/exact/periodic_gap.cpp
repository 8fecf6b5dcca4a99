#include "exact/periodic_gap.hpp"

#include "exact/image_difference.hpp"
#include "exact/periodic_predicate.hpp"
#include "exact/sphere_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::exact {
namespace {

/// Numbers whose sums or products by a shift might overflow, or lose bits in Dekker's splitting,
/// are made smaller first: n A is below 2^1055.
template <int Dim>
double scale_of_numbers(const Sphere<Dim>& a, const Sphere<Dim>& b,
                        const LatticeSteps<Dim>& steps) noexcept {
  double largest = std::max(a.radius, b.radius);
  for (int axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(a.center[axis]), std::fabs(b.center[axis])});
    for (const auto& step : steps) largest = std::max(largest, std::fabs(step.vector[axis]));
  }
  return largest > 0x1p900 ? 0x1p-128 : 1.0;
}

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
  const double first_scale = scale_of_numbers(a, b, steps);
  double difference[Dim];
  double largest = std::max(a.radius, b.radius) * first_scale;
  for (int axis = 0; axis < Dim; ++axis) {
    difference[axis] = image_difference(a, b, steps, axis, first_scale).value().high;
    largest = std::max(largest, std::fabs(difference[axis]));
  }
  const double scale = scale_of_squares(largest);
  double distance_squared = 0.0;
  for (const double component : difference) {
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
