// Signs of orientation: the filters and the exact stages beside rational numbers.

#include "exact/simplices/orientation.hpp"

#include "scenes/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

using exact::Hyperplane;
using exact::orientation_exactly;
using exact::Point;
using scenes::Random;

template <int Dim>
using Points = std::array<Point<Dim>, std::size_t{Dim} + 1>;

mpq_class difference(double a, double b) {
  return mpq_class(a) - mpq_class(b);
}

int by_rationals(const Points<2>& p) {
  const auto d = [&](std::size_t k, std::size_t axis) {
    return difference(p[k][axis], p[0][axis]);
  };
  return sgn(mpq_class(d(1, 0) * d(2, 1) - d(1, 1) * d(2, 0)));
}

/// The rule of P. F. Sarrus.
int by_rationals(const Points<3>& p) {
  const auto d = [&](std::size_t k, std::size_t axis) {
    return difference(p[k][axis], p[0][axis]);
  };
  mpq_class sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += d(1, k) * d(2, (k + 1) % 3) * d(3, (k + 2) % 3);
    sum -= d(1, k) * d(2, (k + 2) % 3) * d(3, (k + 1) % 3);
  }
  return sgn(sum);
}

struct Count {
  std::uint64_t exact_decisions = 0;
  std::array<std::uint64_t, 3> of_sign{};  ///< -1, 0, 1
};

template <int Dim>
void compare(const Points<Dim>& p, Count& count) {
  const int expected = by_rationals(p);
  if constexpr (Dim == 2) {
    const Hyperplane<Point<2>> line(p[0], p[1]);
    ASSERT_EQ(line.certain_side(p[2]).value_or(expected), expected);
    ASSERT_EQ(line.side(p[2], count.exact_decisions), expected);
    ASSERT_EQ(orientation_exactly(p[0], p[1], p[2]), expected);
  } else {
    const Hyperplane<Point<3>> plane(p[0], p[1], p[2]);
    ASSERT_EQ(plane.certain_side(p[3]).value_or(expected), expected);
    ASSERT_EQ(plane.side(p[3], count.exact_decisions), expected);
    ASSERT_EQ(orientation_exactly(p[0], p[1], p[2], p[3]), expected);
  }
  ++count.of_sign[static_cast<std::size_t>(expected + 1)];
}

template <int Dim, class Draw>
Points<Dim> points_of(Draw&& draw) {
  Points<Dim> points{};
  for (auto& point : points) {
    for (double& x : point) x = draw();
  }
  return points;
}

template <int Dim>
struct InSpaceOf {
  static constexpr int dim = Dim;
};
template <class T>
class OrientationOf : public ::testing::Test {};
using Spaces = ::testing::Types<InSpaceOf<2>, InSpaceOf<3>>;
TYPED_TEST_SUITE(OrientationOf, Spaces);

TYPED_TEST(OrientationOf, OrdinaryPointsAreDecidedByTheFilter) {
  constexpr int dim = TypeParam::dim;
  Random random(51);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    const auto draw = [&] { return random.uniform(-1.0, 1.0); };
    ASSERT_NO_FATAL_FAILURE(compare<dim>(points_of<dim>(draw), count));
  }
  EXPECT_EQ(count.exact_decisions, 0U);
}

TYPED_TEST(OrientationOf, ShortNumbersOfManyWidths) {
  constexpr int dim = TypeParam::dim;
  Random random(52);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    // Around the widths at which exact arithmetic goes over to long integers: 40 and 61 bits.
    const int bits = 1 + k % 53;
    const auto draw = [&] {
      const double x = std::floor(std::ldexp(random.uniform(-1.0, 1.0), bits));
      return random.below(4) == 0 ? std::ldexp(x, static_cast<int>(random.below(20))) : x;
    };
    ASSERT_NO_FATAL_FAILURE(compare<dim>(points_of<dim>(draw), count));
  }
  EXPECT_GT(count.of_sign[1], 5U);
}

/// The largest short numbers: all bits set, all signs.
TYPED_TEST(OrientationOf, ExtremeShortNumbers) {
  constexpr int dim = TypeParam::dim;
  Random random(53);
  Count count;
  for (int k = 0; k < 4000; ++k) {
    const int bits = 38 + k % 26;
    const auto draw = [&] {
      const double most = std::ldexp(1.0, bits) - (bits < 53 ? 1.0 : std::ldexp(1.0, bits - 53));
      constexpr std::array<double, 3> factors{-1.0, 1.0, 0.0};
      return random.below(8) == 0 ? 1.0 : factors[random.below(3)] * most;
    };
    ASSERT_NO_FATAL_FAILURE(compare<dim>(points_of<dim>(draw), count));
  }
  EXPECT_GT(count.exact_decisions, 400U);
}

/// The last point on the line or plane through the others but for rounding, at all scales.
TYPED_TEST(OrientationOf, NearlyFlatAtEveryScale) {
  constexpr int dim = TypeParam::dim;
  Random random(54);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    const int exponent = k % 3 == 0 ? 0 : static_cast<int>(random.below(2000)) - 1000;
    auto points = points_of<dim>([&] { return random.uniform(-1.0, 1.0); });
    Point<dim>& last = points[dim];
    last = points[0];
    for (std::size_t j = 1; j < dim; ++j) {
      const double weight = random.uniform(-1.0, 2.0);
      for (std::size_t axis = 0; axis < dim; ++axis) {
        last[axis] += weight * (points[j][axis] - points[0][axis]);
      }
    }
    // From exactly on it, as far as doubles can tell, to clearly beside it.
    const double beside = std::ldexp(1.0, -55 + static_cast<int>(random.below(14)));
    last[0] += random.below(3) == 0 ? 0.0 : beside;
    for (auto& point : points) {
      for (double& x : point) x = std::ldexp(x, exponent);
    }
    ASSERT_NO_FATAL_FAILURE(compare<dim>(points, count));
  }
  EXPECT_GT(count.exact_decisions, 5000U);
  EXPECT_LT(count.exact_decisions, 19000U);
}

/// Products that overflow, or vanish, beside others that do not.
TYPED_TEST(OrientationOf, NumbersOfAllSizesTogether) {
  constexpr int dim = TypeParam::dim;
  Random random(55);
  Count count;
  constexpr std::array<int, 8> exponents{-1074, -1022, -540, -360, -1, 339, 360, 1023};
  for (int k = 0; k < 6000; ++k) {
    const std::size_t sizes = 1 + random.below(exponents.size());
    const auto draw = [&] {
      const double x = random.below(3) == 0 ? 1.0 : random.uniform(-2.0, 2.0);
      return std::ldexp(0.5 * x, exponents[(random.below(sizes) + sizes) % exponents.size()]);
    };
    ASSERT_NO_FATAL_FAILURE(compare<dim>(points_of<dim>(draw), count));
  }
  EXPECT_GT(count.of_sign[0], 1000U);
  EXPECT_GT(count.of_sign[2], 1000U);
}

/// Two products, 0.51 and 0.49 times the smallest double, are rounded to this one and to 0; a large
/// offset makes that an error larger than all else, and of the other sign.
TEST(Orientation, UnderflowTimesALargeNumber) {
  Count count;
  for (const double far : {0x1p340, 0x1p350, 0x1p400, 0x1p1000}) {
    const Points<3> points{{{0, 0, 0},
                            {0, 0x1p-538, 0x1p-538},
                            {1, 0.49 * 0x1p-536, 0.51 * 0x1p-536},
                            {far, -0x1p-537 * far, 0}}};
    ASSERT_NO_FATAL_FAILURE(compare<3>(points, count));
  }
  EXPECT_EQ(count.of_sign[0], 4U);
  EXPECT_EQ(count.exact_decisions, 4U);
}

}  // namespace
}  // namespace abut::testing
