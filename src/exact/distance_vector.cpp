#include "exact/distance_vector.hpp"

#include "exact/center_vector.hpp"
#include "exact/direction.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/periodic_predicate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::exact {
namespace {

/// Smallest component whose square counts beside that of the largest component.
constexpr double smallest_squared = 0x1p-480;

/// Brings differences that exceed this bound back to where their squares can be scaled.
constexpr double scale_of_large = 0x1p-128;

template <int Dim>
double largest_number(const Sphere<Dim>& a, const Sphere<Dim>& b,
                      const LatticeSteps<Dim>& steps) noexcept {
  double largest = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(a.center[axis]), std::fabs(b.center[axis])});
    for (const auto& step : steps) largest = std::max(largest, std::fabs(step.vector[axis]));
  }
  return largest;
}

/// A further power of two that brings a distance near one where squares would leave the range.
double scale_of_squares(double largest) noexcept {
  if (largest > 0x1p400) return 0x1p-600;
  if (largest < 0x1p-400) return 0x1p600;
  return 1.0;
}

/// A number that was multiplied by powers of two, as far as doubles reach. Nearly always by 1,
/// which a branch knows sooner than a division.
double unscaled(double number, double scale, double further = 1.0) noexcept {
  if (scale == 1.0 && further == 1.0) return number;
  return std::clamp(number / scale / further, -largest_double, largest_double);
}

/// The distance lies between two neighboring doubles or is one of them.
struct Enclosure {
  double below;
  double above;
};

// THE ERROR, in units of the distance D. The components err by 2^-105 of themselves, their squares
// and the sum of these by less than 2^-98 (sphere_predicate-inl.hpp does so). With s the rounded
// root of the high part, D - s = (D^2 - s^2) / (D + s); D^2 - s^2 is below 2^-51 and errs by less
// than 2^-97, D + s differs from 2 s by less than 2^-52 of itself. So s + r errs by less than
// 2^-96.
template <int Dim>
Enclosure enclose_distance(const DoubleDouble (&difference)[Dim], double scale) noexcept {
  double high = 0.0;
  double low = 0.0;
  for (const DoubleDouble& component : difference) {
    const double larger = component.high * scale;
    const DoubleDouble term = std::fabs(larger) < smallest_squared
                                  ? DoubleDouble{larger * larger, 0.0}
                                  : square(DoubleDouble{larger, component.low * scale});
    const DoubleDouble sum = two_sum(high, term.high);
    high = sum.high;
    low += sum.low + term.low;
  }
  const double root = std::sqrt(high);
  if (root == 0.0) return {0.0, 0.0};
  const DoubleDouble of_root = two_square(root);
  const double rest = ((high - of_root.high) - of_root.low + low) / (2.0 * root);
  const double error = 0x1p-90 * root;
  return {root + (rest - error), root + (rest + error)};
}

/// Tells whether the distance is at most half of below + above, in real arithmetic.
template <int Dim>
bool is_nearer_to_lower(Sphere<Dim> a, Sphere<Dim> b, const ImageShift& shift,
                        const Lattice& lattice, const Enclosure& distance) noexcept {
  a.radius = 0.5 * distance.below;
  b.radius = 0.5 * distance.above;
  std::uint64_t exact_decisions = 0;
  return within_reach(a, b, shift, lattice, 0.0, exact_decisions);
}

}  // namespace

template <int Dim>
DistanceVector distance_vector(const Sphere<Dim>& a, const Sphere<Dim>& b, const ImageShift& shift,
                               const Lattice& lattice) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  const bool large = largest_number(a, b, steps) > largest_summed;
  DistanceVector result;
  DoubleDouble difference[Dim];
  for (int axis = 0; axis < Dim; ++axis) {
    difference[axis] = large ? any_component(a, b, steps, axis) : component(a, b, steps, axis);
    result.vector[static_cast<std::size_t>(axis)] =
        std::clamp(difference[axis].high, -largest_double, largest_double) + 0.0;
  }
  double scale = 1.0;
  if (largest_of(difference) > largest_summed) {
    // Beside a component that large, what scaling loses of the others is of no account.
    scale = scale_of_large;
    for (int axis = 0; axis < Dim; ++axis) {
      difference[axis] = component(a, b, steps, axis, scale);
    }
  }
  const double further = scale_of_squares(largest_of(difference));
  Enclosure distance = enclose_distance(difference, further);
  distance.below = unscaled(distance.below, further, scale);
  distance.above = unscaled(distance.above, further, scale);
  const bool sure = distance.below >= distance.above || distance.below < 0x1p-1000;
  result.distance =
      sure || is_nearer_to_lower(a, b, shift, lattice, distance) ? distance.below : distance.above;
  return result;
}

template DistanceVector distance_vector(const Sphere<2>&, const Sphere<2>&, const ImageShift&,
                                        const Lattice&) noexcept;
template DistanceVector distance_vector(const Sphere<3>&, const Sphere<3>&, const ImageShift&,
                                        const Lattice&) noexcept;

}  // namespace abut::exact
