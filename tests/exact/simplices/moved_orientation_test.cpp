// Signs of orientation of points that are moved, beside rational numbers.

#include "exact/simplices/moved_orientation.hpp"
#include "scenes/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

using exact::MovedPoint;
using scenes::Random;
using Rational = std::array<mpq_class, 3>;

/// Points, some of which are moved; nothing is known of rounded coordinates.
template <int Dim>
struct Points {
  Points(const exact::Lattice& lattice, const ImageShift& shift)
      : steps(shift, lattice), move{steps, std::numeric_limits<double>::infinity()} {}
  Points(const Points&) = delete;

  void push(const exact::Point<Dim>& given, bool is_moved) {
    MovedPoint<Dim>& point = points[size++];
    point = {given, given, &move, is_moved, {}};
    for (std::size_t axis = 0; axis < Dim; ++axis) point.axes[axis] = axis;
  }

  [[nodiscard]] Rational operator[](std::size_t k) const {
    Rational place;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      place[axis] = mpq_class(points[k].given[axis]);
      if (!points[k].is_moved) continue;
      for (const auto& step : steps) place[axis] += step.number * mpq_class(step.vector[axis]);
    }
    return place;
  }

  exact::LatticeSteps<3> steps;
  exact::Move move;
  std::array<MovedPoint<Dim>, 4> points;
  std::size_t size = 0;
};

int expected_sign(const Points<2>& p) {
  const Rational a = p[0], b = p[1], c = p[2];
  return sgn(mpq_class((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

int expected_sign(const Points<3>& p) {
  std::array<Rational, 3> r;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational from = p[0], to = p[k + 1];
    for (std::size_t axis = 0; axis < 3; ++axis) r[k][axis] = to[axis] - from[axis];
  }
  mpq_class sum;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t next = (axis + 1) % 3, last = (axis + 2) % 3;
    sum += r[2][axis] * (r[0][next] * r[1][last] - r[0][last] * r[1][next]);
  }
  return sgn(sum);
}

int sign(const Points<2>& p) {
  return orientation_exactly(p.points[0], p.points[1], p.points[2]);
}
int sign(const Points<3>& p) {
  return orientation_exactly(p.points[0], p.points[1], p.points[2], p.points[3]);
}

/// Whole numbers of every width, with and beyond what fits into 128 bits.
template <int Dim>
void compare_widths(std::uint64_t seed) {
  Random random(seed);
  std::array<int, 3> seen{};
  for (int k = 0; k < 30000; ++k) {
    const double width = std::ldexp(1.0, 1 + static_cast<int>(random.below(62)));
    const auto whole = [&] { return std::floor(random.uniform(-1.0, 1.0) * width); };
    const double most = std::ldexp(1.0, static_cast<int>(random.below(31)));
    const auto number = [&] { return static_cast<std::int32_t>(random.uniform(-1.0, 1.0) * most); };
    exact::Lattice lattice;
    lattice.periodic = {true, true, Dim == 3};
    for (auto& vector : lattice.vectors) {
      for (double& x : vector) x = whole();
    }
    Points<Dim> points(lattice, {number(), number(), Dim == 3 ? number() : 0});
    for (std::size_t j = 0; j <= Dim; ++j) {
      exact::Point<Dim> point{};
      for (double& x : point) x = whole();
      points.push(point, random.below(2) == 0);
    }
    const int expected = expected_sign(points);
    ASSERT_EQ(sign(points), expected) << "width " << width << ", numbers " << most;
    ++seen[static_cast<std::size_t>(expected + 1)];
  }
  for (const int count : seen) EXPECT_GT(count, 30);
}

TEST(MovedOrientation, WholeNumbersOfAllWidthsInThePlane) {
  compare_widths<2>(71);
}
TEST(MovedOrientation, WholeNumbersOfAllWidthsInSpace) {
  compare_widths<3>(72);
}

/// Along an axis, with and without what rounding may do to what is compared.
TEST(MovedOrientation, Comparisons) {
  exact::Lattice lattice;
  lattice.periodic = {true, false, false};
  lattice.vectors[0] = {10.0 / 3.0, 0.0, 0.0};
  Points<2> points(lattice, {-3, 0, 0});
  points.push({10.0 - 0x1p-49, 1.0}, true);
  points.push({0.0, 1.0}, false);
  points.push({10.0, 1.0}, true);
  const auto& [moved, still, other, unused] = points.points;
  static_cast<void>(unused);
  // 3 (10 / 3) is less than 10 by the rounding of 10 / 3, some 2^-51.
  const int expected = sgn(mpq_class(points[0][0] - points[1][0]));
  EXPECT_EQ(expected, -1);
  EXPECT_EQ(compare_along(0, moved, still), -1);
  EXPECT_EQ(compare_along(0, still, moved), 1);
  EXPECT_EQ(compare_along(0, other, still), sgn(points[2][0]));
  EXPECT_EQ(compare_along(1, moved, still), 0);
  EXPECT_EQ(compare_along(0, moved, other), -1);
  EXPECT_TRUE(moved == moved);
  EXPECT_FALSE(moved == other);
  EXPECT_FALSE(moved == still);
}

}  // namespace
}  // namespace abut::testing
