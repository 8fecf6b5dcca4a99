// Normals, points and vectors of boxes against rational numbers.

#include "exact/box_geometry.hpp"
#include "scenes/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

using scenes::Random;
using Vector = std::array<double, 3>;

struct Case {
  exact::Box<3> a{};
  exact::Box<3> b{};
  ImageShift shift;
  exact::Lattice lattice;
};

/// Half an interval between neighboring doubles, or the double itself.
bool is_nearest(const mpq_class& exact, double rounded) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const mpq_class value(rounded);
  return abs(exact - value) <= abs(exact - mpq_class(std::nextafter(rounded, inf))) &&
         abs(exact - value) <= abs(exact - mpq_class(std::nextafter(rounded, -inf)));
}

mpq_class moved(const Case& c, std::size_t axis) {
  const std::int32_t numbers[] = {c.shift.x, c.shift.y, c.shift.z};
  mpq_class sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += numbers[k] * mpq_class(c.lattice.vectors[k][axis]);
  return sum;
}

void check_axis(const Case& c, const exact::BoxGeometry& found, std::size_t axis) {
  const mpq_class t = moved(c, axis);
  const mpq_class a_lower(c.a.lower[axis]), a_upper(c.a.upper[axis]);
  const mpq_class b_lower = c.b.lower[axis] + t, b_upper = c.b.upper[axis] + t;
  ASSERT_TRUE(is_nearest((b_lower + b_upper - a_lower - a_upper) / 2, found.vector[axis]));
  const mpq_class lower = std::max(a_lower, b_lower), upper = std::min(a_upper, b_upper);
  ASSERT_TRUE(is_nearest((lower + upper) / 2, found.point[axis])) << found.point[axis];
}

void check(const Case& c) {
  const exact::BoxGeometry found = exact::geometry_of(c.a, c.b, c.shift, c.lattice);
  mpq_class square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    check_axis(c, found, axis);
    const mpq_class half =
        (mpq_class(c.b.lower[axis]) + c.b.upper[axis] - c.a.lower[axis] - c.a.upper[axis]) / 2 +
        moved(c, axis);
    square += half * half;
  }
  const mpf_class distance = sqrt(mpf_class(square, 2400));
  const double last_place = std::nextafter(found.distance, 1e308) - found.distance;
  ASSERT_LE(abs(mpf_class(found.distance, 2400) - distance), mpf_class(last_place, 2400));
}

Case some_case(Random& random, double scale, bool is_moved) {
  const auto number = [&] {
    const double fine = random.uniform(-1.0, 1.0);
    return scale * (random.below(2) == 0 ? std::round(fine * 4.0) / 4.0 : fine);
  };
  Case c;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (exact::Box<3>* box : {&c.a, &c.b}) {
      const double first = number(), second = number();
      box->lower[axis] = std::min(first, second);
      box->upper[axis] = std::max(first, second);
    }
    for (auto& vector : c.lattice.vectors) vector[axis] = number();
    c.lattice.periodic[axis] = true;
  }
  if (is_moved) c.shift = {1, -2, static_cast<std::int32_t>(random.below(3))};
  return c;
}

TEST(BoxGeometry, IsRoundedOnce) {
  Random random(1503);
  for (const double scale : {1.0, 0x1p300, 0x1p-600, 0x1p950}) {
    for (const bool is_moved : {false, true}) {
      for (int round = 0; round < 300; ++round) check(some_case(random, scale, is_moved));
    }
  }
}

exact::BoxGeometry of(const exact::Box<3>& a, const exact::Box<3>& b) {
  return exact::geometry_of(a, b, {}, {});
}

TEST(BoxGeometry, PointsAlongTheLargestSeparation) {
  const exact::Box<3> a{{0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}};
  EXPECT_EQ(of(a, {{0.0, 1.5, 0.0}, {2.0, 3.0, 2.0}}).normal, (Vector{0.0, 1.0, 0.0}));
  EXPECT_EQ(of(a, {{0.5, 0.5, -5.0}, {1.0, 1.0, -1.0}}).normal, (Vector{0.0, 0.0, -1.0}));
  // Of equal separations the first axis; where centers agree on it, no direction.
  EXPECT_EQ(of(a, {{1.0, 1.0, 1.0}, {3.0, 3.0, 3.0}}).normal, (Vector{1.0, 0.0, 0.0}));
  EXPECT_EQ(of(a, a).normal, (Vector{0.0, 0.0, 0.0}));
  EXPECT_EQ(of(a, a).point, (Vector{1.0, 1.0, 1.0}));
  EXPECT_EQ(of(a, {{3.0, 0.5, 0.0}, {4.0, 1.0, 1.0}}).point, (Vector{2.5, 0.75, 0.5}));
}

}  // namespace
}  // namespace abut::testing
