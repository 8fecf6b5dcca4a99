#include "exact/features/box_feature.hpp"

#include "exact/image_difference.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/periodic_box.hpp"
#include "exact/periodic_predicate.hpp"

#include <cmath>

namespace abut::exact {
namespace {

template <int Dim>
int exact_sign_of_difference(const Sphere<Dim>& a, const Sphere<Dim>& b,
                             const LatticeSteps<Dim>& steps, int axis) noexcept {
  const CompensatedSum sum = image_difference(a, b, steps, axis);
  if (!sum.rounded()) {
    const double value = sum.value().high;
    return value < 0.0 ? -1 : value > 0.0 ? 1 : 0;
  }
  ExactAccumulator<1> all;
  all.add(a.center[axis], 1);
  all.add(b.center[axis], -1);
  for (const auto& step : steps) all.add(step.vector[axis], -std::int64_t{step.number});
  return all.sign();
}

/// The sign of x_a - x_b - n A on one axis, in real arithmetic. The filter is that of boxes with a
/// lattice (periodic_box.hpp), with less to add up. Adds one to `doubts` where it cannot tell.
template <int Dim>
int sign_of_difference(const Sphere<Dim>& a, const Sphere<Dim>& b, const LatticeSteps<Dim>& steps,
                       int axis, std::uint64_t& doubts) noexcept {
  double value = a.center[axis] - b.center[axis];
  double moved = 0.0;
  for (const auto& step : steps) {
    const double product = step.number * step.vector[axis];
    value -= product;
    moved += std::fabs(product);
  }
  if (moved == 0.0) return (a.center[axis] > b.center[axis]) - (a.center[axis] < b.center[axis]);
  const double magnitude = moved + std::fabs(a.center[axis]) + std::fabs(b.center[axis]);
  if (magnitude >= smallest_safe_box_magnitude && magnitude <= largest_safe_box_magnitude &&
      std::fabs(value) > box_band * magnitude) {
    return value < 0.0 ? -1 : 1;
  }
  ++doubts;
  return exact_sign_of_difference(a, b, steps, axis);
}

template <int Dim>
Sphere<Dim> point_at(const double (&corner)[Dim]) noexcept {
  Sphere<Dim> point{};
  std::copy_n(corner, Dim, point.center);
  return point;
}

}  // namespace

template <int Dim>
BoxSides<Dim> nearest_sides(const Sphere<Dim>& sphere, const Box<Dim>& box,
                            const LatticeSteps<Dim>& steps, std::uint64_t& doubts) noexcept {
  const Sphere<Dim> lower = point_at(box.lower);
  const Sphere<Dim> upper = point_at(box.upper);
  BoxSides<Dim> sides{};
  for (int axis = 0; axis < Dim; ++axis) {
    std::int8_t& side = sides[static_cast<std::size_t>(axis)];
    if (sign_of_difference(sphere, lower, steps, axis, doubts) <= 0) {
      side = -1;
    } else if (sign_of_difference(sphere, upper, steps, axis, doubts) >= 0) {
      side = lower.center[axis] == upper.center[axis] ? -1 : 1;
    }
  }
  return sides;
}

template <int Dim>
SideCorner<Dim>::SideCorner(const Sphere<Dim>& sphere, const Box<Dim>& box,
                            const BoxSides<Dim>& sides, const Lattice& given) noexcept
    : center(sphere), nearest{}, lattice(given) {
  for (int axis = 0; axis < Dim; ++axis) {
    const std::int8_t side = sides[static_cast<std::size_t>(axis)];
    if (side == 0) {
      center.center[axis] = 0.0;
      for (auto& vector : lattice.vectors) vector[static_cast<std::size_t>(axis)] = 0.0;
    } else {
      nearest.center[axis] = side < 0 ? box.lower[axis] : box.upper[axis];
    }
  }
}

template <int Dim>
std::optional<BoxSides<Dim>> sides_within_reach(const Sphere<Dim>& sphere, const Box<Dim>& box,
                                                const ImageShift& shift, const Lattice& lattice,
                                                double margin,
                                                std::uint64_t& exact_decisions) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  if (steps.empty()) return sides_within_reach(sphere, box, margin, exact_decisions);
  std::uint64_t doubts = 0;
  const BoxSides<Dim> sides = nearest_sides(sphere, box, steps, doubts);
  const SideCorner<Dim> across(sphere, box, sides, lattice);
  const bool within =
      within_reach(across.center, across.nearest, shift, across.lattice, margin, doubts);
  exact_decisions += doubts == 0 ? 0 : 1;
  if (!within) return std::nullopt;
  return sides;
}

template BoxSides<2> nearest_sides<2>(const Sphere<2>&, const Box<2>&, const LatticeSteps<2>&,
                                      std::uint64_t&) noexcept;
template BoxSides<3> nearest_sides<3>(const Sphere<3>&, const Box<3>&, const LatticeSteps<3>&,
                                      std::uint64_t&) noexcept;
template struct SideCorner<2>;
template struct SideCorner<3>;
template std::optional<BoxSides<2>> sides_within_reach<2>(const Sphere<2>&, const Box<2>&,
                                                          const ImageShift&, const Lattice&, double,
                                                          std::uint64_t&) noexcept;
template std::optional<BoxSides<3>> sides_within_reach<3>(const Sphere<3>&, const Box<3>&,
                                                          const ImageShift&, const Lattice&, double,
                                                          std::uint64_t&) noexcept;

}  // namespace abut::exact
