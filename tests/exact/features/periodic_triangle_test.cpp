// Spheres against triangles that a lattice moves: the predicate beside rational numbers.

#include "exact/features/triangle_cases.hpp"
#include "exact/periodic_pairs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>

namespace abut::testing {
namespace {

using exact::Sphere;
using exact::Triangle;
using exact::TrianglePart;

struct Case : TriangleCase {
  exact::Lattice lattice;
  ImageShift shift;

  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    out << static_cast<const TriangleCase&>(c) << std::hexfloat;
    for (std::size_t k = 0; k < 3; ++k) {
      out << (c.lattice.periodic[k] ? ", vector" : ", open");
      for (const double x : c.lattice.vectors[k]) out << ' ' << x;
    }
    return out << std::defaultfloat << ", shift " << c.shift.x << ' ' << c.shift.y << ' '
               << c.shift.z;
  }
};

using Count = PartCount;

void compare(const Case& c, Count& count) {
  const RationalPoint center = moved_back(c.sphere.center, c.shift, c.lattice);
  const auto expected =
      part_within_reach_by_rationals(center, c.sphere.radius, c.triangle, c.margin);
  ASSERT_EQ(exact::part_within_reach(c.sphere, c.triangle, c.shift, c.lattice, c.margin,
                                     count.exact_decisions),
            expected)
      << c;
  const exact::LatticeSteps<3> steps(c.shift, c.lattice);
  ASSERT_EQ(exact::part_within_reach_exactly(c.sphere, c.triangle, steps, c.margin), expected) << c;
  count.note(expected);
}

/// A lattice and a shift as pairs of spheres have them.
void take_lattice(Case& c, const PeriodicPair<3>& pair) {
  c.lattice = pair.lattice;
  c.shift = pair.shift;
}

void plant_reach(Case& c, Random& random) {
  plant_reach(c, moved_back(c.sphere.center, c.shift, c.lattice), random);
}

/// Near the triangle when it is moved by whole vectors, so that what is left is what heavy
/// cancellation leaves.
Case cancelling_case(Random& random, int bits_of_shift, bool coarse) {
  Case c{};
  PeriodicPair<3> pair{};
  choose_periodic_axes(pair, bits_of_shift, random);
  set_lattice<3>(
      pair,
      coarse ? [](Random& r) { return short_number(r, 4); }
             : [](Random& r) { return r.uniform(-1.0, 1.0); },
      random);
  take_lattice(c, pair);
  const auto draw = [&] { return coarse ? short_number(random, 3) : random.uniform(-1.0, 1.0); };
  for (auto& corner : c.triangle.corner) {
    for (double& x : corner) x = draw();
  }
  // Minus what the origin is moved back by.
  const RationalPoint back = moved_back(c.sphere.center, c.shift, c.lattice);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    c.sphere.center[axis] = draw() - back[axis].get_d();
  }
  return c;
}

TEST(PeriodicTriangle, OrdinaryCasesAreDecidedByTheFilter) {
  Random random(31);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    Case c = cancelling_case(random, 3, false);
    c.sphere.radius = random.uniform(0.0, 1.5);
    c.margin = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 0.3);
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_LE(count.exact_decisions, 4U);
  EXPECT_LT(count.within, count.cases * 9 / 10);
  expect_all_parts(count, 500);
}

/// The center is three doubles when moved back: corners that coincide or lie on a line, centers
/// over corners and sides, exact ties.
TEST(PeriodicTriangle, ShortNumbersAtShiftsOfAllBits) {
  Random random(32);
  Count count;
  for (int k = 0; k < 30000; ++k) {
    Case c = cancelling_case(random, 1 + k % 31, true);
    c.sphere.radius = static_cast<double>(random.below(5)) * 0.25;
    c.margin = static_cast<double>(random.below(2)) * 0.25;
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, 1000U);
  expect_all_parts(count, 200);
}

TEST(PeriodicTriangle, ReachPlantedAtTheDistance) {
  Random random(33);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    Case c = cancelling_case(random, 1 + k % 31, k % 3 == 0);
    plant_reach(c, random);
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, count.cases * 8 / 10);
  EXPECT_GT(count.within, count.cases / 4);
  EXPECT_LT(count.within, count.cases * 3 / 4);
  expect_all_parts(count, 100);
}

/// Where the nearest part changes: the moved center over a point of a side, but for rounding.
TEST(PeriodicTriangle, CentersOnTheBordersOfParts) {
  Random random(34);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    Case c = cancelling_case(random, 1 + k % 8, false);
    const std::size_t from = random.below(3);
    const std::size_t to = (from + 1) % 3;
    const double along = k % 2 == 0 ? 0.0 : random.uniform(0.0, 1.0);
    RationalPoint back = moved_back({0.0, 0.0, 0.0}, c.shift, c.lattice);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double edge = c.triangle.corner[to][axis] - c.triangle.corner[from][axis];
      const double point = c.triangle.corner[from][axis] + along * edge;
      c.sphere.center[axis] = point - back[axis].get_d();
    }
    c.sphere.radius = 100.0;
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.exact_decisions, 5000U);
}

TEST(PeriodicTriangle, AtEveryScale) {
  Random random(35);
  Count count;
  for (int exponent = -1040; exponent <= 980; exponent += 20) {
    for (int k = 0; k < 12; ++k) {
      Case c = cancelling_case(random, 1 + k % 20, k % 2 == 0);
      plant_reach(c, random);
      scale(c, exponent);
      for (auto& vector : c.lattice.vectors) {
        for (double& x : vector) x = std::ldexp(x, exponent);
      }
      ASSERT_NO_FATAL_FAILURE(compare(c, count)) << "2^" << exponent;
    }
  }
}

TEST(PeriodicTriangle, ExtremeNumbers) {
  Random random(36);
  Count count;
  for (int k = 0; k < 1500; ++k) {
    Case c{};
    take_lattice(c, extreme_periodic_pair<3>(random));
    for (double& x : c.sphere.center) x = extreme_number(random);
    for (auto& corner : c.triangle.corner) {
      for (double& x : corner) x = extreme_number(random);
    }
    c.sphere.radius = std::fabs(extreme_number(random));
    c.margin = random.below(2) == 0 ? 0.0 : std::fabs(extreme_number(random));
    ASSERT_NO_FATAL_FAILURE(compare(c, count));
  }
  EXPECT_GT(count.within, 50U);
  EXPECT_LT(count.within, 1450U);
}

TEST(PeriodicTriangle, WithoutAShiftItIsTheQuestionOfOpenSpace) {
  Random random(37);
  for (int k = 0; k < 2000; ++k) {
    Case c = cancelling_case(random, 1, k % 2 == 0);
    plant_reach(c, random);
    c.shift = {};
    std::uint64_t of_images = 0, of_open = 0;
    EXPECT_EQ(
        exact::part_within_reach(c.sphere, c.triangle, c.shift, c.lattice, c.margin, of_images),
        exact::part_within_reach(c.sphere, c.triangle, c.margin, of_open));
    EXPECT_EQ(of_images, of_open);
  }
}

}  // namespace
}  // namespace abut::testing
