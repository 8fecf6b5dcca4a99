// Spheres and the nearest points of solid boxes against rational numbers.

#include "exact/features/solid_geometry.hpp"
#include "exact/features/geometry_oracle.hpp"
#include "exact/periodic_pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

using Vector = std::array<double, 3>;

template <int Dim>
struct Case {
  exact::Sphere<Dim> sphere{};
  exact::Box<Dim> box{};
  ImageShift shift;
  exact::Lattice lattice;
};

template <int Dim>
mpq_class moved(const Case<Dim>& c, double bound, std::size_t axis) {
  const std::int32_t numbers[] = {c.shift.x, c.shift.y, c.shift.z};
  mpq_class sum(bound);
  for (std::size_t k = 0; k < Dim; ++k) {
    if (c.lattice.periodic[k]) sum += numbers[k] * mpq_class(c.lattice.vectors[k][axis]);
  }
  return sum;
}

template <int Dim>
void check(const Case<Dim>& c) {
  RationalPoint center, lower, upper;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    center[axis] = c.sphere.center[axis];
    lower[axis] = moved(c, c.box.lower[axis], axis);
    upper[axis] = moved(c, c.box.upper[axis], axis);
  }
  const exact::FeatureGeometry found =
      exact::geometry_of(c.sphere, c.box, c.shift, c.lattice, all_quantities);
  ASSERT_EQ(fault_of(found, geometry_of_box(center, lower, upper, Dim), c.sphere.radius), "")
      << c.sphere.center[0] << ' ' << c.sphere.center[1] << " in " << c.box.lower[0] << ' '
      << c.box.upper[0] << ' ' << c.box.lower[1] << ' ' << c.box.upper[1];
}

template <int Dim, class Draw>
Case<Dim> case_of(Draw&& draw) {
  Case<Dim> c;
  for (int axis = 0; axis < Dim; ++axis) {
    const double first = draw(), second = draw();
    c.box.lower[axis] = std::min(first, second);
    c.box.upper[axis] = std::max(first, second);
    c.sphere.center[axis] = draw();
  }
  c.sphere.radius = std::fabs(draw());
  return c;
}

template <int Dim, class Draw>
void add_lattice(Case<Dim>& c, Random& random, Draw&& draw, int bits) {
  for (std::size_t k = 0; k < 3; ++k) {
    // What lies beyond the dimensions means nothing.
    for (double& x : c.lattice.vectors[k]) x = draw();
    c.lattice.periodic[k] = k < Dim;
  }
  c.shift = {random_number_of_cells(random, bits), random_number_of_cells(random, bits), 0};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    c.sphere.center[axis] += moved(c, 0.0, axis).get_d();
  }
}

template <int Dim>
void check_all(std::uint64_t seed) {
  Random random(seed);
  const auto fine = [&] { return random.uniform(-1.0, 1.0); };
  const auto coarse = [&] { return short_number(random, 2); };
  for (int k = 0; k < 4000; ++k) {
    Case<Dim> c = k % 2 == 0 ? case_of<Dim>(fine) : case_of<Dim>(coarse);
    if (k % 3 == 0)
      k % 2 == 0 ? add_lattice(c, random, fine, k % 31) : add_lattice(c, random, coarse, k % 31);
    check(c);
  }
}

TEST(SolidGeometry, InThreeDimensions) {
  check_all<3>(1611);
}

TEST(SolidGeometry, InTwoDimensions) {
  check_all<2>(1612);
}

TEST(SolidGeometry, AtEveryScale) {
  Random random(1613);
  for (int exponent = -1060; exponent <= 990; exponent += 10) {
    const auto draw = [&] {
      const double fine = random.uniform(-1.0, 1.0);
      return std::ldexp(random.below(2) == 0 ? fine : std::round(4.0 * fine) / 4.0, exponent);
    };
    for (int k = 0; k < 8; ++k) {
      Case<3> c = case_of<3>(draw);
      if (k % 2 == 0) add_lattice(c, random, draw, 1 + k);
      check(c);
    }
  }
}

TEST(SolidGeometry, OfExtremeNumbers) {
  Random random(1614);
  for (int k = 0; k < 2000; ++k) check(case_of<3>([&] { return extreme_number(random); }));
}

exact::FeatureGeometry at(const Vector& center, const exact::Box<3>& box) {
  return exact::geometry_of<3>({{center[0], center[1], center[2]}, 0.5}, box, {}, {},
                               all_quantities);
}

/// A center that passes through a face meets no jump of gap, normal or point.
TEST(SolidGeometry, GoesOnThroughAFace) {
  const exact::Box<3> box{{0.0, 0.0, 0.0}, {4.0, 4.0, 4.0}};
  const double heights[] = {4.25, 4.0, 3.75};
  for (const double z : heights) {
    const exact::FeatureGeometry found = at({2.0, 1.0, z}, box);
    EXPECT_EQ(found.gap, z - 4.5);
    EXPECT_EQ(found.distance, z - 4.0);
    EXPECT_EQ(found.normal, (Vector{0.0, 0.0, -1.0}));
    EXPECT_EQ(found.point, (Vector{2.0, 1.0, 4.0}));
    EXPECT_EQ(found.vector, (Vector{0.0, 0.0, 4.0 - z}));
  }
}

TEST(SolidGeometry, TakesTheFirstOfSeveralFaces) {
  const exact::Box<3> box{{0.0, 0.0, 0.0}, {2.0, 2.0, 2.0}};
  EXPECT_EQ(at({1.0, 1.0, 1.0}, box).normal, (Vector{1.0, 0.0, 0.0}));
  EXPECT_EQ(at({2.0, 2.0, 2.0}, box).normal, (Vector{-1.0, 0.0, 0.0}));
  EXPECT_EQ(at({1.0, 0.5, 1.5}, box).normal, (Vector{0.0, 1.0, 0.0}));
  EXPECT_EQ(at({1.0, 1.0, 1.0}, {{0.0, 1.0, 0.0}, {2.0, 1.0, 2.0}}).normal,
            (Vector{0.0, 1.0, 0.0}));
}

}  // namespace
}  // namespace abut::testing
