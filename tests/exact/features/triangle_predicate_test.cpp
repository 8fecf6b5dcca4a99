// Spheres against triangles: the predicate beside rational numbers.

#include "exact/features/triangle_predicate.hpp"

#include "exact/features/triangle_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

namespace abut::testing {
namespace {

using exact::Sphere;
using exact::Triangle;
using exact::TrianglePart;

using Case = TriangleCase;
using Count = PartCount;

void compare(const Case& c, Count& count) {
  const auto expected = part_within_reach_by_rationals(c.sphere, c.triangle, c.margin);
  ASSERT_EQ(exact::part_within_reach(c.sphere, c.triangle, c.margin, count.exact_decisions),
            expected)
      << c;
  ASSERT_EQ(exact::part_within_reach_exactly(c.sphere, c.triangle, c.margin), expected) << c;
  count.note(expected);
}

/// Fills center and corners with numbers from `draw`.
template <class Draw>
Case case_of(Draw&& draw) {
  Case c{};
  for (double& x : c.sphere.center) x = draw();
  for (auto& corner : c.triangle.corner) {
    for (double& x : corner) x = draw();
  }
  return c;
}

void plant_reach(Case& c, Random& random) {
  plant_reach(c, rational(c.sphere.center), random);
}

TEST(TrianglePredicate, OrdinaryCasesAreDecidedByTheFilter) {
  Random random(11);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    Case c = case_of([&] { return random.uniform(-1.0, 1.0); });
    c.sphere.radius = random.uniform(0.0, 1.5);
    c.margin = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.3);
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_LE(count.exact_decisions, 2U);
  EXPECT_LT(count.within, count.cases * 9 / 10);
  expect_all_parts(count, 500);
}

/// Few numbers: corners that coincide or lie on a line, centers above corners and sides.
TEST(TrianglePredicate, SmallIntegersAndTrianglesWithoutArea) {
  Random random(12);
  Count count;
  for (int k = 0; k < 40000; ++k) {
    const std::uint64_t most = 2 + random.below(3);
    Case c = case_of([&] { return static_cast<double>(random.next() % (most + 1)); });
    c.sphere.radius = static_cast<double>(random.below(5)) * 0.5;
    c.margin = static_cast<double>(random.below(2)) * 0.5;
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, 10000U);
  expect_all_parts(count, 300);
}

TEST(TrianglePredicate, ReachPlantedAtTheDistance) {
  Random random(13);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    const int bits = 3 + static_cast<int>(random.below(50));
    Case c = case_of([&] { return short_number(random, bits); });
    plant_reach(c, random);
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, count.cases * 9 / 10);
  EXPECT_GT(count.within, count.cases / 4);
  EXPECT_LT(count.within, count.cases * 3 / 4);
  expect_all_parts(count, 100);
}

TEST(TrianglePredicate, ReachPlantedAtTheDistanceAtEveryScale) {
  Random random(14);
  Count count;
  for (int exponent = -1070; exponent <= 1020; exponent += 10) {
    for (int k = 0; k < 10; ++k) {
      Case c = case_of([&] { return short_number(random, 20); });
      plant_reach(c, random);
      scale(c, exponent);
      ASSERT_NO_FATAL_FAILURE(compare(c, count)) << "2^" << exponent;
    }
  }
}

/// Where the filter stops: sides and distances of very different sizes.
TEST(TrianglePredicate, NeedlesGiantsAndSpecks) {
  Random random(15);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    const int exponents[3] = {static_cast<int>(random.below(60)) - 30,
                              static_cast<int>(random.below(60)) - 30,
                              static_cast<int>(random.below(60)) - 30};
    Case c = case_of([&] { return random.uniform(-1.0, 1.0); });
    for (int axis = 0; axis < 3; ++axis) {
      for (auto& corner : c.triangle.corner)
        corner[axis] = std::ldexp(corner[axis], exponents[axis]);
    }
    const int away = static_cast<int>(random.below(60)) - 30;
    for (double& x : c.sphere.center) x = std::ldexp(x, away);
    plant_reach(c, random);
    if (random.below(2) == 0) c.sphere.radius *= random.uniform(0.9, 1.1);
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_LT(count.exact_decisions, count.cases);
  expect_all_parts(count, 20);
}

/// Whole numbers of so many bits, the reach too, on both sides of what fits into 128 bits.
TEST(TrianglePredicate, WholeNumbersOfSomeTwentyBits) {
  Random random(19);
  Count count;
  for (int k = 0; k < 16000; ++k) {
    const double most = std::ldexp(1.0, 17 + k % 8) - 1.0;
    Case c = case_of([&] {
      return random.below(2) == 0 ? (random.below(2) == 0 ? most : -most)
                                  : std::round(random.uniform(-most, most));
    });
    const NearestPart nearest = nearest_part_by_rationals(c.sphere.center, c.triangle);
    c.sphere.radius = std::round(std::sqrt(nearest.distance_squared.get_d()));
    if (random.below(2) == 0) c.sphere.radius = std::round(random.uniform(0.0, 2.0 * most));
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.within, count.cases / 4);
  EXPECT_LT(count.within, count.cases * 3 / 4);
  expect_all_parts(count, 50);
}

TEST(TrianglePredicate, ExtremeNumbers) {
  Random random(16);
  Count count;
  for (int k = 0; k < 1500; ++k) {
    Case c = case_of([&] { return extreme_number(random); });
    c.sphere.radius = std::fabs(extreme_number(random));
    c.margin = random.below(2) == 0 ? 0.0 : std::fabs(extreme_number(random));
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.within, 100U);
  EXPECT_LT(count.within, 1400U);
}

/// A plane with the normal (2, 3, 6), which has the length 7, and points of a lattice in it.
Triangle lattice_triangle(const std::array<std::array<int, 2>, 3>& steps) {
  Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [s, t] = steps[k];
    const int point[3] = {3 * s, -2 * s + 2 * t, -t};
    for (std::size_t axis = 0; axis < 3; ++axis) triangle.corner[k][axis] = point[axis];
  }
  return triangle;
}

/// Over each point of a lattice, at a distance that is a whole number: it touches, and with the
/// radius below it does not.
TEST(TrianglePredicate, ExactTiesTouchOverCornerSideAndFace) {
  const Triangle triangle = lattice_triangle({{{0, 0}, {6, 0}, {0, 6}}});
  Count count;
  for (int s = 0; s <= 6; ++s) {
    for (int t = 0; s + t <= 6; ++t) {
      const Triangle foot = lattice_triangle({{{s, t}, {s, t}, {s, t}}});
      for (const int height : {-1, 1, 3}) {
        Case c{{}, triangle, 0.0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          c.sphere.center[axis] = foot.corner[0][axis] + height * std::array{2, 3, 6}[axis];
        }
        c.sphere.radius = std::abs(7 * height);
        const int ends = (s == 0) + (t == 0) + (s + t == 6);
        const auto part =
            exact::part_within_reach(c.sphere, c.triangle, 0.0, count.exact_decisions);
        ASSERT_TRUE(part) << c;
        EXPECT_EQ(*part == TrianglePart::face, ends == 0) << c;
        EXPECT_EQ(*part <= TrianglePart::corner_2, ends == 2) << c;
        ASSERT_NO_FATAL_FAILURE(compare(c, count));
        c.sphere.radius = std::nextafter(c.sphere.radius, 0.0);
        ASSERT_NO_FATAL_FAILURE(compare(c, count));
      }
    }
  }
  EXPECT_EQ(count.within, count.cases / 2);
  EXPECT_EQ(count.parts[TrianglePart::corner_0], 3U);
  EXPECT_EQ(count.parts[TrianglePart::side_12], 15U);
  EXPECT_EQ(count.parts[TrianglePart::face], 30U);
}

using Numbers = std::array<double, 3>;

Numbers cross(const Numbers& a, const Numbers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// From one corner to another.
Numbers edge_of(const Triangle& triangle, std::size_t from, std::size_t to) {
  Numbers edge{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    edge[axis] = triangle.corner[to][axis] - triangle.corner[from][axis];
  }
  return edge;
}

/// Where the nearest part changes: over a point of a side (at a corner for `along` = 0), and away
/// from it across the side, so that only rounding decides on which side of the border the center
/// is.
TEST(TrianglePredicate, CentersOnTheBordersOfParts) {
  Random random(18);
  Count count;
  for (int k = 0; k < 40000; ++k) {
    Case c = case_of([&] { return random.uniform(-1.0, 1.0); });
    const std::size_t from = random.below(3);
    const std::size_t to = (from + 1) % 3;
    const Numbers edge = edge_of(c.triangle, from, to);
    const Numbers normal = cross(edge, edge_of(c.triangle, from, (from + 2) % 3));
    const Numbers across = cross(edge, normal);
    const bool at_corner = k % 2 == 0;
    const double along = at_corner ? 0.0 : random.uniform(0.0, 1.0);
    const double sideways = at_corner ? random.uniform(0.0, 1.0) : 0.0;
    const double up = random.uniform(-1.0, 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.sphere.center[axis] = c.triangle.corner[from][axis] + along * edge[axis] +
                              sideways * across[axis] + up * normal[axis];
    }
    c.sphere.radius = 100.0;
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, 20000U);
  expect_all_parts(count, 1000);
}

/// Two triangles with a common side agree on it: if one is nearest on the open side, the other is
/// not nearest at an end of it.
TEST(TrianglePredicate, TrianglesAgreeOnACommonSide) {
  Random random(17);
  std::uint64_t exact_decisions = 0;
  std::uint64_t on_side = 0;
  for (int k = 0; k < 50000; ++k) {
    const bool coarse = k % 2 == 0;
    Case c = case_of(
        [&] { return coarse ? static_cast<double>(random.below(4)) : random.uniform(-1.0, 1.0); });
    c.sphere.radius = 100.0;
    Triangle other = c.triangle;
    for (double& x : other.corner[2])
      x = coarse ? static_cast<double>(random.below(4)) : random.uniform(-1, 1);
    const auto first = exact::part_within_reach(c.sphere, c.triangle, 0.0, exact_decisions);
    const auto second = exact::part_within_reach(c.sphere, other, 0.0, exact_decisions);
    ASSERT_TRUE(first && second);
    if (*first != TrianglePart::side_01) continue;
    ++on_side;
    ASSERT_NE(*second, TrianglePart::corner_0) << c;
    ASSERT_NE(*second, TrianglePart::corner_1) << c;
  }
  EXPECT_GT(on_side, 1000U);
}

}  // namespace
}  // namespace abut::testing
