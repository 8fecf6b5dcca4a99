#include "exact/features/exact_nearest.hpp"

#include "exact/direction.hpp"
#include "exact/features/nearest_part.hpp"
#include "exact/numbers/bit_range.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/numbers/scaled_number.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace abut::exact {
namespace {

int lowest_exponent(const Sphere<3>& sphere, const Triangle& triangle,
                    const LatticeSteps<3>& steps) noexcept {
  BitRange range;
  for (const auto& corner : triangle.corner) include(range, corner);
  include(range, sphere.center);
  include(range, steps);
  range.include(sphere.radius);
  return range.lowest();
}

}  // namespace

ExactNearest::ExactNearest(const Sphere<3>& sphere, const Triangle& triangle, TrianglePart part,
                           const LatticeSteps<3>& steps) noexcept
    : exponent_(lowest_exponent(sphere, triangle, steps)), radius_(sphere.radius, exponent_) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    center_[axis] = BigInteger(sphere.center[axis], exponent_);
  }
  const IntegerVector<BigInteger> center = moved_back(sphere.center, steps, exponent_);
  const auto corner = [&](std::size_t k) {
    return IntegerVector<BigInteger>(triangle.corner[k], exponent_) - center;
  };
  if (part <= TrianglePart::corner_2) {
    take_corner(corner(static_cast<std::size_t>(part)));
  } else if (part == TrianglePart::face) {
    const IntegerVector<BigInteger> first = corner(0);
    take_plane(first, cross(corner(1) - first, corner(2) - first));
  } else {
    const auto [from, to] = ends_of(part);
    const IntegerVector<BigInteger> first = corner(from);
    take_line(first, corner(to) - first);
  }
}

void ExactNearest::take_corner(const IntegerVector<BigInteger>& corner) noexcept {
  vector_[0] = corner.x;
  vector_[1] = corner.y;
  vector_[2] = corner.z;
  divisor_ = BigInteger(1.0, 0);
  distance_squared_ = dot(corner, corner);
  of_square_ = BigInteger(1.0, 0);
}

/// The vector is e x (w x e) / e^2 with w from the center to a point of the line.
void ExactNearest::take_line(const IntegerVector<BigInteger>& from,
                             const IntegerVector<BigInteger>& edge) noexcept {
  const IntegerVector<BigInteger> moment = cross(from, edge);
  const IntegerVector<BigInteger> vector = cross(edge, moment);
  vector_[0] = vector.x;
  vector_[1] = vector.y;
  vector_[2] = vector.z;
  divisor_ = dot(edge, edge);
  distance_squared_ = dot(moment, moment);
  of_square_ = divisor_;
}

/// The vector is n (w n) / n^2.
void ExactNearest::take_plane(const IntegerVector<BigInteger>& corner,
                              const IntegerVector<BigInteger>& normal) noexcept {
  const BigInteger height = dot(corner, normal);
  vector_[0] = normal.x * height;
  vector_[1] = normal.y * height;
  vector_[2] = normal.z * height;
  divisor_ = dot(normal, normal);
  distance_squared_ = height * height;
  of_square_ = divisor_;
}

double ExactNearest::distance() const noexcept {
  const ScaledNumber square =
      ScaledNumber(distance_squared_, 2 * exponent_) / ScaledNumber(of_square_, 0);
  return square.root().rounded();
}

/// (d^2 - r^2) / (d + r), which cancels nothing that is not exact.
double ExactNearest::gap() const noexcept {
  const BigInteger difference = distance_squared_ - radius_ * radius_ * of_square_;
  if (difference.sign() == 0) return 0.0;
  const ScaledNumber divisor(of_square_, 0);
  const ScaledNumber distance = (ScaledNumber(distance_squared_, 2 * exponent_) / divisor).root();
  const ScaledNumber both = distance + ScaledNumber(radius_, exponent_);
  const double gap = (ScaledNumber(difference, 2 * exponent_) / (divisor * both)).rounded();
  if (difference.sign() < 0) return gap;
  return std::max(gap, std::numeric_limits<double>::denorm_min());
}

std::array<double, 3> ExactNearest::vector() const noexcept {
  const ScaledNumber divisor(divisor_, 0);
  std::array<double, 3> vector{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    vector[axis] = (ScaledNumber(vector_[axis], exponent_) / divisor).rounded();
  }
  return vector;
}

std::array<double, 3> ExactNearest::normal() const noexcept {
  std::array<double, 3> normal{};
  if (distance_squared_.sign() == 0) return normal;
  const ScaledNumber scaled[3]{ScaledNumber(vector_[0], 0), ScaledNumber(vector_[1], 0),
                               ScaledNumber(vector_[2], 0)};
  int largest = std::numeric_limits<int>::min();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (vector_[axis].sign() != 0) largest = std::max(largest, scaled[axis].exponent());
  }
  const DoubleDouble vector[3]{scaled[0].over(largest), scaled[1].over(largest),
                               scaled[2].over(largest)};
  const Direction<3> direction = direction_of(vector);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    normal[axis] = direction.unit[axis].high + direction.unit[axis].low + 0.0;
  }
  return normal;
}

std::array<double, 3> ExactNearest::point() const noexcept {
  const ScaledNumber divisor(divisor_, 0);
  std::array<double, 3> point{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const BigInteger scaled = center_[axis] * divisor_ + vector_[axis];
    point[axis] = (ScaledNumber(scaled, exponent_) / divisor).rounded();
  }
  return point;
}

}  // namespace abut::exact
