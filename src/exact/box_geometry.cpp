#include "exact/box_geometry.hpp"

#include "exact/direction.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/numbers/exact_sum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>

namespace abut::exact {
namespace {

double clamped(double value) noexcept {
  return std::clamp(value, -largest_double, largest_double);
}

/// Returns what moved_sum does, for numbers of any size.
template <int Dim>
DoubleDouble any_sum(std::initializer_list<double> numbers, const LatticeSteps<Dim>& steps,
                     std::size_t axis, double scale) noexcept {
  ExactAccumulator<1> sum;
  for (const double number : numbers) sum.add(number, 1);
  for (const auto& step : steps) sum.add(scale * step.vector[axis], std::int64_t{step.number});
  const double high = sum.rounded();
  if (!(std::fabs(high) < largest_double)) return {clamped(high), 0.0};
  sum.add(high, -1);
  return {high, sum.rounded()};
}

/// A sum of numbers and of `scale` times what moves b along an axis, rounded once; and what is left
/// of it, rounded.
template <int Dim>
DoubleDouble moved_sum(std::initializer_list<double> numbers, const LatticeSteps<Dim>& steps,
                       std::size_t axis, double scale) noexcept {
  double largest = 0.0;
  for (const double number : numbers) largest = std::max(largest, std::fabs(number));
  for (const auto& step : steps) largest = std::max(largest, std::fabs(step.vector[axis]));
  if (largest > largest_summed) return any_sum(numbers, steps, axis, scale);
  ExactSum<10> sum;
  for (const double number : numbers) sum.add(number);
  for (const auto& step : steps) {
    sum.add(two_product(static_cast<double>(step.number), scale * step.vector[axis]));
  }
  const double high = sum.rounded();
  sum.add(-high);
  return {high, sum.rounded()};
}

/// The ends of a and b on one axis, b as it is given.
struct BoxEnds {
  double a_lower, a_upper, b_lower, b_upper;
};

/// Returns the vector from center to center on one axis.
template <int Dim>
DoubleDouble between_centers(const BoxEnds& ends, const LatticeSteps<Dim>& steps,
                             std::size_t axis) noexcept {
  return moved_sum(
      {0.5 * ends.b_lower, 0.5 * ends.b_upper, -0.5 * ends.a_lower, -0.5 * ends.a_upper}, steps,
      axis, 1.0);
}

/// The larger of the two separations on one axis, rounded once.
template <int Dim>
double separation(const BoxEnds& ends, const LatticeSteps<Dim>& steps, std::size_t axis) noexcept {
  const double b_behind_a = moved_sum({ends.b_lower, -ends.a_upper}, steps, axis, 1.0).high;
  const double a_behind_b = -moved_sum({ends.b_upper, -ends.a_lower}, steps, axis, 1.0).high;
  return std::max(b_behind_a, a_behind_b);
}

/// The middle between the larger lower end and the smaller upper end. Whose that is, the sign of an
/// exact difference tells.
template <int Dim>
double middle(const BoxEnds& ends, const LatticeSteps<Dim>& steps, std::size_t axis) noexcept {
  const bool lower_is_b = moved_sum({ends.b_lower, -ends.a_lower}, steps, axis, 1.0).high > 0.0;
  const bool upper_is_b = moved_sum({ends.b_upper, -ends.a_upper}, steps, axis, 1.0).high < 0.0;
  const double lower = lower_is_b ? ends.b_lower : ends.a_lower;
  const double upper = upper_is_b ? ends.b_upper : ends.a_upper;
  const double moved = (lower_is_b ? 0.5 : 0.0) + (upper_is_b ? 0.5 : 0.0);
  return moved_sum({0.5 * lower, 0.5 * upper}, steps, axis, moved).high + 0.0;
}

}  // namespace

template <int Dim>
BoxGeometry geometry_of(const Box<Dim>& a, const Box<Dim>& b, const ImageShift& shift,
                        const Lattice& lattice) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  BoxGeometry result;
  DoubleDouble vector[Dim];
  std::size_t decisive = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const BoxEnds ends{a.lower[axis], a.upper[axis], b.lower[axis], b.upper[axis]};
    vector[axis] = between_centers(ends, steps, axis);
    result.vector[axis] = vector[axis].high + 0.0;
    result.point[axis] = middle(ends, steps, axis);
    const double apart = separation(ends, steps, axis);
    if (apart > largest) {
      largest = apart;
      decisive = axis;
    }
  }
  const double side = result.vector[decisive];
  result.normal[decisive] = side > 0.0 ? 1.0 : side < 0.0 ? -1.0 : 0.0;
  const double longest = largest_of(vector);
  if (longest > 0.0) {
    const Direction<Dim> direction = direction_of_any(vector);
    const double scaled = direction.root + direction.rest;
    result.distance = clamped(std::ldexp(scaled, -exponent_to_one(longest)));
  }
  return result;
}

template BoxGeometry geometry_of(const Box<2>&, const Box<2>&, const ImageShift&,
                                 const Lattice&) noexcept;
template BoxGeometry geometry_of(const Box<3>&, const Box<3>&, const ImageShift&,
                                 const Lattice&) noexcept;

}  // namespace abut::exact
