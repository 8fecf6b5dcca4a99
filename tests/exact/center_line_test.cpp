// Normals and points of contact against numbers of 2,400 bits: within one unit in the last place of
// the largest component.

#include "exact/center_line.hpp"
#include "scenes/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace abut::testing {
namespace {

using scenes::Random;
using Vector = std::array<double, 3>;

constexpr double largest = std::numeric_limits<double>::max();
constexpr unsigned bits = 2400;

mpf_class number(double value) {
  return mpf_class(value, bits);
}

struct Case {
  exact::Sphere<3> a{};
  exact::Sphere<3> b{};
  ImageShift shift;
  exact::Lattice lattice;
};

/// What exact::CenterLine computes, with 2,400 bits.
struct Expected {
  explicit Expected(const Case& c) {
    const std::int32_t numbers[] = {c.shift.x, c.shift.y, c.shift.z};
    mpf_class square(0, bits);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      vector[axis] = number(c.b.center[axis]) - number(c.a.center[axis]);
      for (std::size_t k = 0; k < 3; ++k) {
        vector[axis] += numbers[k] * number(c.lattice.vectors[k][axis]);
      }
      square += vector[axis] * vector[axis];
    }
    const mpf_class distance = sqrt(square);
    const mpf_class radii = (number(c.a.radius) - number(c.b.radius)) / 2;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      normal[axis] = distance == 0 ? number(0.0) : mpf_class(vector[axis] / distance);
      point[axis] = number(c.a.center[axis]) + vector[axis] / 2 + normal[axis] * radii;
    }
  }

  std::array<mpf_class, 3> vector{number(0), number(0), number(0)};
  std::array<mpf_class, 3> normal{number(0), number(0), number(0)};
  std::array<mpf_class, 3> point{number(0), number(0), number(0)};
};

/// A unit in the last place of the largest component.
double last_place(const Vector& vector) {
  double size = 0.0;
  for (const double x : vector) size = std::max(size, std::fabs(x));
  if (size == largest) return 0x1p971;
  return std::nextafter(size, largest) - size;
}

double largest_number(const Case& c) {
  double size = std::max(c.a.radius, c.b.radius);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    size = std::max({size, std::fabs(c.a.center[axis]), std::fabs(c.b.center[axis])});
    for (const auto& vector : c.lattice.vectors) size = std::max(size, std::fabs(vector[axis]));
  }
  return size;
}

void check(const Case& c) {
  const Expected expected(c);
  const exact::CenterLine<3> line(c.a, c.b, c.shift, c.lattice);
  const Vector normal = line.normal();
  const Vector point = line.point();
  const mpf_class of_numbers = number(largest_number(c)) * 0x1p-94;
  const mpf_class of_point = std::max(number(last_place(point)), of_numbers);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ASSERT_LE(abs(number(normal[axis]) - expected.normal[axis]), number(last_place(normal)))
        << "normal, axis " << axis << ": " << normal[axis];
    ASSERT_FALSE(std::signbit(normal[axis]) && normal[axis] == 0.0);
    if (abs(expected.point[axis]) > largest) continue;
    ASSERT_LE(abs(number(point[axis]) - expected.point[axis]), of_point)
        << "point, axis " << axis << ": " << point[axis];
  }
  const ImageShift back{-c.shift.x, -c.shift.y, -c.shift.z};
  const Vector opposite = exact::CenterLine<3>(c.b, c.a, back, c.lattice).normal();
  for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(opposite[axis], 0.0 - normal[axis]);
}

/// Numbers of some scale, now and then on a grid, where much is exact.
double some_number(Random& random, double scale) {
  const double fine = random.uniform(-1.0, 1.0);
  return scale * (random.below(3) == 0 ? std::round(fine * 8.0) / 8.0 : fine);
}

Case some_case(Random& random, double scale, double radius, std::int32_t most_cells) {
  Case c;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    c.a.center[axis] = some_number(random, scale);
    c.b.center[axis] = some_number(random, scale);
    for (auto& vector : c.lattice.vectors) vector[axis] = some_number(random, scale);
    c.lattice.periodic[axis] = true;
  }
  c.a.radius = std::fabs(some_number(random, radius));
  c.b.radius = random.below(3) == 0 ? c.a.radius : std::fabs(some_number(random, radius));
  const auto cells = [&] {
    return static_cast<std::int32_t>(random.below(2 * static_cast<std::uint64_t>(most_cells) + 1)) -
           most_cells;
  };
  if (most_cells > 0) c.shift = {cells(), cells(), cells()};
  return c;
}

TEST(CenterLine, ErrsByOneUnitInTheLastPlaceAtMost) {
  Random random(1501);
  for (const double scale : {1.0, 0x1p-30, 1e9, 0x1p300, 0x1p-380, 0x1p700, 0x1p1000, 0x1p-1050}) {
    for (const double radius : {0.0, 1.0, 0x1p-20, 0x1p20}) {
      for (const std::int32_t cells : {0, 1, 1000}) {
        const double size = std::min(scale * radius, 0x1p1010);
        for (int round = 0; round < 60; ++round) check(some_case(random, scale, size, cells));
      }
    }
  }
}

TEST(CenterLine, KeepsItsBoundWhereTheLatticeCancels) {
  Random random(1502);
  for (const double scale : {1.0, 0x1p500, 0x1p950}) {
    for (int round = 0; round < 500; ++round) {
      Case c = some_case(random, scale, scale * 0x1p-60, 3);
      // b lies where it comes to lie on a, but for some last places.
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int32_t numbers[] = {c.shift.x, c.shift.y, c.shift.z};
        c.b.center[axis] = c.a.center[axis];
        for (std::size_t k = 0; k < 3; ++k) {
          c.b.center[axis] -= numbers[k] * c.lattice.vectors[k][axis];
        }
      }
      check(c);
    }
  }
}

TEST(CenterLine, OfOnePointHasNoDirection) {
  const exact::Sphere<3> a{{1.0, -2.0, 3.0}, 0.5};
  const exact::Sphere<3> b{{1.0, -2.0, 3.0}, 0.25};
  const exact::CenterLine<3> line(a, b, {}, {});
  EXPECT_EQ(line.normal(), (Vector{0.0, 0.0, 0.0}));
  EXPECT_EQ(line.point(), (Vector{1.0, -2.0, 3.0}));
}

/// The vector (2, 1) times the largest double: in its direction, cut off, it would be (1, 1).
TEST(CenterLine, OfCentersFartherApartThanTheLargestDouble) {
  const double huge = std::numeric_limits<double>::max();
  const exact::Sphere<2> a{{-huge, -0.5 * huge}, 0x1p1000};
  const exact::Sphere<2> b{{huge, 0.5 * huge}, 0x1p1000};
  const exact::CenterLine<2> line(a, b, {}, {});
  EXPECT_NEAR(line.normal()[0], 2.0 / std::sqrt(5.0), 0x1p-52);
  EXPECT_NEAR(line.normal()[1], 1.0 / std::sqrt(5.0), 0x1p-52);
  EXPECT_EQ(line.point(), (Vector{0.0, 0.0, 0.0}));
  exact::Lattice lattice;
  lattice.vectors[0] = {huge, -huge, 0.0};
  lattice.periodic[0] = true;
  const exact::CenterLine<2> shifted(a, a, {4, 0, 0}, lattice);
  EXPECT_NEAR(shifted.normal()[0], std::sqrt(0.5), 0x1p-52);
  EXPECT_NEAR(shifted.normal()[1], -std::sqrt(0.5), 0x1p-52);
}

/// A radius is the largest double, and the other one half a unit in its last place, or some and a
/// half: their sum is rounded away from 0.
TEST(CenterLine, OfTheLargestRadius) {
  for (int k = 0; k < 40; ++k) {
    Case c{{{1.0, 2.0, -3.0}, 0.5 * k * 0x1p971}, {{-4.0, 0.5, 2.0}, largest}, {}, {}};
    check(c);
    std::swap(c.a.radius, c.b.radius);
    check(c);
  }
}

TEST(CenterLine, OfSymmetricSpheresMeetsInTheMiddle) {
  const exact::Sphere<2> a{{-1.0, 0.3}, 1.5};
  const exact::Sphere<2> b{{1.0, -0.3}, 1.5};
  EXPECT_EQ(exact::CenterLine<2>(a, b, {}, {}).point(), (Vector{0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace abut::testing
