// Vectors and distances against rational arithmetic: each rounded once.

#include "exact/distance_vector.hpp"
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

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

struct Case {
  exact::Sphere<3> a{};
  exact::Sphere<3> b{};
  ImageShift shift;
  exact::Lattice lattice;
};

mpq_class component(const Case& c, std::size_t axis) {
  const std::int32_t numbers[] = {c.shift.x, c.shift.y, c.shift.z};
  mpq_class result = mpq_class(c.b.center[axis]) - mpq_class(c.a.center[axis]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (numbers[k] != 0) result += numbers[k] * mpq_class(c.lattice.vectors[k][axis]);
  }
  return result;
}

/// Whether `rounded` is the nearest double to `exact`, to even between two; beyond the largest
/// double that one.
bool is_rounded(const mpq_class& exact, double rounded) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (abs(exact) >= largest) return rounded == (sgn(exact) < 0 ? -largest : largest);
  if (std::fabs(rounded) == largest) return abs(mpq_class(rounded) - exact) < 0x1p970;
  const mpq_class value(rounded);
  const mpq_class above = (value + mpq_class(std::nextafter(rounded, inf))) / 2;
  const mpq_class below = (value + mpq_class(std::nextafter(rounded, -inf))) / 2;
  int exponent = 0;
  const bool even = std::fmod(std::ldexp(std::frexp(rounded, &exponent), 53), 2.0) == 0.0;
  return even ? below <= exact && exact <= above : below < exact && exact < above;
}

/// Whether `rounded` is the nearest double to the root of `square`, the smaller of two.
bool is_rounded_root(const mpq_class& square, double rounded) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (square >= mpq_class(largest) * largest) return rounded == largest;
  if (rounded == largest) {
    const mpq_class below = mpq_class(largest) - 0x1p970;
    return below * below < square;
  }
  const mpq_class above = (mpq_class(rounded) + mpq_class(std::nextafter(rounded, inf))) / 2;
  if (rounded == 0.0) return square <= above * above;
  const mpq_class below = (mpq_class(rounded) + mpq_class(std::nextafter(rounded, -inf))) / 2;
  return below * below < square && square <= above * above;
}

void check(const Case& c) {
  const exact::DistanceVector found = exact::distance_vector(c.a, c.b, c.shift, c.lattice);
  mpq_class square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const mpq_class exact = component(c, axis);
    ASSERT_TRUE(is_rounded(exact, found.vector[axis])) << found.vector[axis] << " axis " << axis;
    square += exact * exact;
  }
  if (found.distance > 0x1p-1000) {
    ASSERT_TRUE(is_rounded_root(square, found.distance)) << found.distance;
  } else {
    // Off by the last place at most, as documented.
    const mpq_class error =
        1.5 * (mpq_class(std::nextafter(found.distance, 1.0)) - mpq_class(found.distance));
    const mpq_class below = std::max<mpq_class>(0, mpq_class(found.distance) - error);
    ASSERT_LE(below * below, square) << found.distance;
    const mpq_class above = mpq_class(found.distance) + error;
    ASSERT_GE(above * above, square) << found.distance;
  }
  const exact::DistanceVector back =
      exact::distance_vector(c.b, c.a, {-c.shift.x, -c.shift.y, -c.shift.z}, c.lattice);
  ASSERT_EQ(back.distance, found.distance);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ASSERT_EQ(back.vector[axis], -found.vector[axis]);
    ASSERT_FALSE(found.vector[axis] == 0.0 && std::signbit(found.vector[axis]));
  }
}

/// Numbers of few bits, of which some sums cancel, and of many.
double number(Random& random, int exponents) {
  const double significand =
      random.below(3) == 0 ? static_cast<double>(random.below(9)) - 4.0 : random.uniform(-1.0, 1.0);
  const auto steps = random.below(static_cast<std::size_t>(exponents));
  return std::ldexp(significand, static_cast<int>(steps) - exponents / 2);
}

Case random_case(Random& random, int exponents, bool shifted) {
  Case c;
  for (int axis = 0; axis < 3; ++axis) {
    c.a.center[axis] = number(random, exponents);
    c.b.center[axis] = number(random, exponents);
  }
  c.lattice.periodic = {true, true, true};
  for (auto& vector : c.lattice.vectors) {
    for (double& x : vector) x = number(random, exponents);
  }
  if (!shifted) return c;
  const auto whole = [&] { return static_cast<std::int32_t>(random.below(9)) - 4; };
  c.shift = {whole(), whole(), random.below(2) == 0 ? 2147483647 : whole()};
  // Nearly all of it cancels now and then.
  if (random.below(2) == 0) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      c.a.center[axis] -= component(c, axis).get_d();
    }
  }
  return c;
}

TEST(DistanceVector, IsRoundedOnce) {
  Random random(1);
  for (int k = 0; k < 5000; ++k) {
    for (const int exponents : {1, 10, 60, 400}) {
      check(random_case(random, exponents, false));
      check(random_case(random, exponents, true));
      if (HasFatalFailure()) return;
    }
  }
}

/// Along one axis the distance is the component; between two doubles it is the smaller one.
TEST(DistanceVector, OfTies) {
  const auto along_x = [](double a, double b) {
    return exact::distance_vector<3>({{a, 5, 5}, 1.0}, {{b, 5, 5}, 2.0}, {}, {});
  };
  EXPECT_EQ(along_x(1.0, 4.0).distance, 3.0);
  EXPECT_EQ(along_x(0x1p53, -1.0).distance, 0x1p53);
  EXPECT_EQ(along_x(0x1p53 + 2.0, -1.0).distance, 0x1p53 + 2.0);
  EXPECT_EQ(along_x(0x1p53 + 2.0, -1.0).vector[0], -(0x1p53 + 4.0));
  EXPECT_EQ(along_x(7.0, 7.0).distance, 0.0);
}

TEST(DistanceVector, OfExtremeNumbers) {
  const auto between = [](double a, double b) {
    return exact::distance_vector<2>({{a, 0}, 0.0}, {{b, 0}, 0.0}, {}, {});
  };
  EXPECT_EQ(between(largest, -largest).distance, largest);
  EXPECT_EQ(between(-largest, largest).vector[0], largest);
  EXPECT_EQ(between(largest, 0.0).distance, largest);
  EXPECT_EQ(between(smallest, 0.0).distance, smallest);
  EXPECT_EQ(between(3 * smallest, -2 * smallest).distance, 5 * smallest);
  EXPECT_EQ(between(1e300, 2e300).distance, 1e300);
  const exact::DistanceVector diagonal =
      exact::distance_vector<2>({{0x3p666, 0x4p666}, 0.0}, {{0, 0}, 0.0}, {}, {});
  EXPECT_EQ(diagonal.distance, 0x5p666);
}

/// A few last places of the smallest numbers, or some of the largest, or ordinary ones.
double extreme_number(Random& random) {
  const double significand = static_cast<double>(random.below(17)) - 8.0;
  switch (random.below(5)) {
    case 0:
      return 0.0;
    case 1:
      return significand * smallest;
    case 2:
      return std::ldexp(significand, static_cast<int>(random.below(122)) + 898);
    case 3:
      return std::ldexp(significand, -static_cast<int>(random.below(200)) - 874);
    default:
      return random.uniform(-1.0, 1.0) * std::ldexp(largest, -static_cast<int>(random.below(2000)));
  }
}

Case extreme_case(Random& random) {
  Case c;
  c.lattice.periodic = {true, true, true};
  for (auto& vector : c.lattice.vectors) {
    for (double& x : vector) x = extreme_number(random);
  }
  const auto whole = [&] {
    return random.below(3) == 0 ? static_cast<std::int32_t>(random.below(9)) - 4 : 0;
  };
  c.shift = {whole(), whole(), random.below(8) == 0 ? -2147483647 : whole()};
  for (int axis = 0; axis < 3; ++axis) {
    c.a.center[axis] = extreme_number(random);
    c.b.center[axis] = random.below(3) == 0 ? c.a.center[axis] : extreme_number(random);
  }
  if (random.below(2) == 0) return c;
  // Nearly all of it cancels; what is left is below the last place of the numbers.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const mpq_class near_zero = component(c, axis);
    if (abs(near_zero) < largest) c.b.center[axis] -= near_zero.get_d();
    if (std::isinf(c.b.center[axis])) c.b.center[axis] = 0.0;
  }
  return c;
}

TEST(DistanceVector, OfSmallBesideLargeNumbersIsRoundedOnce) {
  Random random(2);
  for (int k = 0; k < 20'000; ++k) {
    check(extreme_case(random));
    if (HasFatalFailure()) FAIL() << "case " << k;
  }
}

TEST(DistanceVector, OfLastPlacesBesideTheLargestNumbers) {
  const exact::DistanceVector open =
      exact::distance_vector<2>({{0x1p1000, 3 * smallest}, 0.0}, {{0x1p1000, 0}, 0.0}, {}, {});
  EXPECT_EQ(open.vector[1], -3 * smallest);
  EXPECT_EQ(open.distance, 3 * smallest);
  exact::Lattice lattice;
  lattice.periodic = {true, false, false};
  lattice.vectors[0] = {0x1p1000, 0.0, 0.0};
  const exact::DistanceVector moved = exact::distance_vector<2>(
      {{0x1p1000, 0}, 0.0}, {{-5 * smallest, 0}, 0.0}, {1, 0, 0}, lattice);
  EXPECT_EQ(moved.vector[0], -5 * smallest);
  EXPECT_EQ(moved.distance, 5 * smallest);
}

}  // namespace
}  // namespace abut::testing
