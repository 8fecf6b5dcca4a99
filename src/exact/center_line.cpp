#include "exact/center_line.hpp"

#include "exact/cancellation.hpp"
#include "exact/center_vector.hpp"
#include "exact/direction.hpp"
#include "exact/image_difference.hpp"

#include <algorithm>
#include <cmath>

namespace abut::exact {
namespace {

/// Tells whether a component of v is neither so large nor so small that its square leaves the
/// range.
bool is_ordinary(double component) noexcept {
  const double magnitude = std::fabs(component);
  return magnitude == 0.0 || (magnitude >= smallest_ordinary && magnitude <= largest_ordinary);
}

/// a - b. The larger one comes first: of the largest double as the second one what `two_sum` seeks
/// may be beyond it.
DoubleDouble difference_of_radii(double a, double b) noexcept {
  return a >= b ? two_sum(a, -b) : two_sum(-b, a);
}

/// start + (v + unit * radii) / 2 on one axis.
double point_on(double start, const DoubleDouble& vector, const DoubleDouble& unit,
                const DoubleDouble& radii) noexcept {
  const DoubleDouble middle = two_sum(start, 0.5 * vector.high);
  const double half_high = 0.5 * radii.high;
  const DoubleDouble along = two_product(unit.high, half_high);
  const double along_low = along.low + (unit.high * (0.5 * radii.low) + unit.low * half_high);
  const DoubleDouble point = two_sum(middle.high, along.high);
  return point.high + (point.low + ((middle.low + 0.5 * vector.low) + along_low));
}

}  // namespace

template <int Dim>
CenterLine<Dim>::CenterLine(const Sphere<Dim>& a, const Sphere<Dim>& b, const ImageShift& shift,
                            const Lattice& lattice) noexcept
    : a_(a), difference_of_radii_(difference_of_radii(a.radius, b.radius)) {
  const LatticeSteps<Dim> steps(shift, lattice);
  const double largest = largest_term(a, b, steps);
  if (!(largest <= largest_summed)) {
    subtract_large(b, steps);
    return;
  }
  is_ordinary_ = std::max({largest, a.radius, b.radius}) <= largest_ordinary;
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDouble opposite = image_difference(a, b, steps, axis).value();
    vector_[axis] = {-opposite.high, -opposite.low};
    is_ordinary_ = is_ordinary_ && exact::is_ordinary(opposite.high);
  }
  if (steps.empty() || largest_of(vector_) >= most_cancellation * largest) return;
  is_ordinary_ = false;
  for (int axis = 0; axis < Dim; ++axis) vector_[axis] = component(a, b, steps, axis);
}

/// Components beyond the largest double are kept times a power of two.
template <int Dim>
void CenterLine<Dim>::subtract_large(const Sphere<Dim>& b,
                                     const LatticeSteps<Dim>& steps) noexcept {
  is_ordinary_ = false;
  bool finite = true;
  for (int axis = 0; axis < Dim; ++axis) {
    vector_[axis] = any_component(a_, b, steps, axis);
    finite = finite && std::isfinite(vector_[axis].high);
  }
  if (finite) return;
  exponent_ = -128;
  for (int axis = 0; axis < Dim; ++axis) vector_[axis] = component(a_, b, steps, axis, 0x1p-128);
}

template <int Dim>
std::array<double, 3> CenterLine<Dim>::normal() const noexcept {
  std::array<double, 3> normal{};
  if (largest_of(vector_) == 0.0) return normal;
  const Direction<Dim> direction = is_ordinary_ ? direction_of(vector_) : direction_of_any(vector_);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    normal[axis] = direction.unit[axis].high + direction.unit[axis].low + 0.0;
  }
  return normal;
}

template <int Dim>
std::array<double, 3> CenterLine<Dim>::point() const noexcept {
  std::array<double, 3> point{};
  const double length = largest_of(vector_);
  Direction<Dim> direction{};
  if (length > 0.0) direction = is_ordinary_ ? direction_of(vector_) : direction_of_any(vector_);
  DoubleDouble vector[Dim];
  std::copy(vector_, vector_ + Dim, vector);
  DoubleDouble radii = difference_of_radii_;
  int exponent = exponent_;
  if (!is_ordinary_) {
    double largest = std::max(length, std::fabs(std::ldexp(radii.high, exponent)));
    for (const double x : a_.center) {
      largest = std::max(largest, std::fabs(std::ldexp(x, exponent)));
    }
    const int further = largest > 0.0 ? exponent_to_one(largest) : 0;
    scale_by(vector, further);
    exponent += further;
    radii = {std::ldexp(radii.high, exponent), std::ldexp(radii.low, exponent)};
  }
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double start = exponent == 0 ? a_.center[axis] : std::ldexp(a_.center[axis], exponent);
    const double scaled = point_on(start, vector[axis], direction.unit[axis], radii);
    const double found = exponent == 0 ? scaled : std::ldexp(scaled, -exponent);
    point[axis] = std::clamp(found, -largest_double, largest_double) + 0.0;
  }
  return point;
}

template class CenterLine<2>;
template class CenterLine<3>;

}  // namespace abut::exact
