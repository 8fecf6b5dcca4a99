// Spheres and the nearest points of vertices, edges and faces against rational numbers.

#include "exact/features/feature_geometry.hpp"
#include "exact/features/geometry_oracle.hpp"
#include "exact/features/triangle_cases.hpp"
#include "exact/periodic_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

namespace abut::testing {
namespace {

using exact::Feature;

struct Case {
  exact::Sphere<3> sphere{};
  Feature feature{};
  ImageShift shift;
  exact::Lattice lattice;
};

exact::Triangle triangle_of(const Feature& feature) {
  exact::Triangle triangle{};
  for (int k = 0; k < 3; ++k) {
    std::copy_n(feature.corner[std::min(k, feature.corners - 1)], 3, triangle.corner[k]);
  }
  return triangle;
}

std::string text_of(const Case& c) {
  std::ostringstream out;
  out << TriangleCase{c.sphere, triangle_of(c.feature), 0.0} << ", " << c.feature.corners
      << " corners, shift " << c.shift.x << ' ' << c.shift.y << ' ' << c.shift.z << std::hexfloat;
  for (const auto& vector : c.lattice.vectors) {
    for (const double x : vector) out << ' ' << x;
  }
  return out.str();
}

void check(const Case& c) {
  const RationalPoint seen_from = moved_back(c.sphere.center, c.shift, c.lattice);
  const NearestPart nearest = nearest_part_by_rationals(seen_from, triangle_of(c.feature));
  const exact::FeatureGeometry found =
      exact::geometry_of(c.sphere, c.feature, c.shift, c.lattice, all_quantities);
  const WallGeometry expected{rational(c.sphere.center), nearest.vector, nearest.vector,
                              nearest.distance_squared};
  ASSERT_EQ(fault_of(found, expected, c.sphere.radius), "") << text_of(c);
  // What is measured does not depend on what else is.
  const auto alone = [&](Quantity quantity) {
    return exact::geometry_of(c.sphere, c.feature, c.shift, c.lattice, quantity);
  };
  ASSERT_EQ(alone(Quantity::gap).gap, found.gap);
  ASSERT_EQ(alone(Quantity::point).point, found.point);
  ASSERT_EQ(alone(Quantity::normal).normal, found.normal);
}

/// Numbers from `draw`; on periodic axes the lattice moves the feature back from where it is far.
template <class Draw>
Case case_of(Draw&& draw, int corners) {
  Case c;
  c.feature.corners = corners;
  for (double& x : c.sphere.center) x = draw();
  for (auto& corner : c.feature.corner) {
    for (double& x : corner) x = draw();
  }
  c.sphere.radius = std::fabs(draw());
  return c;
}

/// Three periodic axes and a shift; the sphere is moved to where the feature comes to lie.
template <class Draw>
void add_lattice(Case& c, Random& random, Draw&& draw, int bits_of_shift) {
  for (auto& vector : c.lattice.vectors) {
    for (double& x : vector) x = draw();
  }
  c.lattice.periodic = {true, true, true};
  c.shift = {random_number_of_cells(random, bits_of_shift),
             random_number_of_cells(random, bits_of_shift), 0};
  const RationalPoint back = moved_back({0.0, 0.0, 0.0}, c.shift, c.lattice);
  for (std::size_t axis = 0; axis < 3; ++axis) c.sphere.center[axis] -= back[axis].get_d();
}

void plant_radius(Case& c, Random& random) {
  TriangleCase planted{c.sphere, triangle_of(c.feature), 0.0};
  plant_reach(planted, moved_back(c.sphere.center, c.shift, c.lattice), random);
  c.sphere.radius = planted.sphere.radius + planted.margin;
}

void scale(Case& c, int exponent) {
  const auto scale_all = [&](auto& numbers) {
    for (double& x : numbers) x = std::ldexp(x, exponent);
  };
  scale_all(c.sphere.center);
  for (auto& corner : c.feature.corner) scale_all(corner);
  for (auto& vector : c.lattice.vectors) scale_all(vector);
  c.sphere.radius = std::ldexp(c.sphere.radius, exponent);
}

TEST(FeatureGeometry, OfOrdinaryNumbers) {
  Random random(1601);
  const auto draw = [&] { return random.uniform(-1.0, 1.0); };
  for (int k = 0; k < 3000; ++k) {
    Case c = case_of(draw, 1 + k % 3);
    if (k % 2 == 0) add_lattice(c, random, draw, 1 + k % 31);
    check(c);
  }
}

/// Corners that coincide or lie on a line, centers on features, exact touching.
TEST(FeatureGeometry, OfNumbersOfFewBits) {
  Random random(1602);
  const auto draw = [&] { return short_number(random, 2); };
  for (int k = 0; k < 4000; ++k) {
    Case c = case_of(draw, 1 + k % 3);
    if (k % 2 == 0) add_lattice(c, random, draw, 1 + k % 31);
    check(c);
  }
}

TEST(FeatureGeometry, WhereSpheresTouchButForTheLastPlaces) {
  Random random(1603);
  const auto draw = [&] { return random.uniform(-1.0, 1.0); };
  for (int k = 0; k < 2000; ++k) {
    Case c = case_of(draw, 1 + k % 3);
    if (k % 2 == 0) add_lattice(c, random, draw, 1 + k % 8);
    plant_radius(c, random);
    check(c);
  }
}

/// Centers that lie all but on the feature, and points all but at the origin.
TEST(FeatureGeometry, WhereDigitsCancel) {
  Random random(1604);
  const auto draw = [&] { return random.uniform(-1.0, 1.0); };
  for (int k = 0; k < 3000; ++k) {
    Case c = case_of(draw, 2 + k % 2);
    const double weights[] = {random.uniform(0.0, 0.5), random.uniform(0.0, 0.5)};
    const double away = std::ldexp(1.0, -static_cast<int>(random.below(70)));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& [p, q, r] = c.feature.corner;
      const double on = p[axis] + weights[0] * (q[axis] - p[axis]) +
                        (c.feature.corners == 3 ? weights[1] * (r[axis] - p[axis]) : 0.0);
      c.sphere.center[axis] = on + away * draw();
      if (k % 3 > 0) continue;
      for (double* x : {&c.feature.corner[0][axis], &c.feature.corner[1][axis],
                        &c.feature.corner[2][axis], &c.sphere.center[axis]}) {
        *x -= on;
      }
    }
    c.sphere.radius = std::fabs(away * draw());
    check(c);
  }
}

TEST(FeatureGeometry, OfNeedlesAndSplinters) {
  Random random(1605);
  const auto draw = [&] { return random.uniform(-1.0, 1.0); };
  for (int k = 0; k < 2000; ++k) {
    Case c = case_of(draw, 3);
    const double thin = std::ldexp(1.0, -static_cast<int>(random.below(60)));
    const double weight = random.uniform(-1.0, 2.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto& [p, q, r] = c.feature.corner;
      r[axis] = p[axis] + weight * (q[axis] - p[axis]) + thin * draw();
    }
    check(c);
  }
}

TEST(FeatureGeometry, AtEveryScale) {
  Random random(1606);
  const auto draw = [&] {
    return random.below(2) == 0 ? random.uniform(-1.0, 1.0) : short_number(random, 3);
  };
  for (int exponent = -1060; exponent <= 990; exponent += 10) {
    for (int k = 0; k < 6; ++k) {
      Case c = case_of(draw, 1 + k % 3);
      if (k > 2) add_lattice(c, random, draw, 1 + k);
      scale(c, exponent);
      check(c);
    }
  }
}

TEST(FeatureGeometry, OfExtremeNumbers) {
  Random random(1607);
  for (int k = 0; k < 1500; ++k) {
    Case c = case_of([&] { return extreme_number(random); }, 1 + k % 3);
    if (k % 2 == 0) {
      const PeriodicPair<3> pair = extreme_periodic_pair<3>(random);
      c.lattice = pair.lattice;
      c.shift = pair.shift;
    }
    check(c);
  }
}

TEST(FeatureGeometry, OfACenterOnTheWallHasNoNormal) {
  const Feature face{{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {0.0, 3.0, 0.0}}, 3};
  const exact::FeatureGeometry found =
      exact::geometry_of({{1.0, 1.0, 0.0}, 0.5}, face, {}, {}, all_quantities);
  EXPECT_EQ(found.gap, -0.5);
  EXPECT_EQ(found.distance, 0.0);
  EXPECT_EQ(found.normal, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(found.vector, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(found.point, (std::array{1.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace abut::testing
