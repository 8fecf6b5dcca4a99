// The predicate of boxes and their gap against rational numbers.

#include "exact/box.hpp"

#include "scenes/random.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

bool at_most_by_rationals(double a, double b, double margin) {
  return mpq_class(a) <= mpq_class(b) + mpq_class(margin);
}

bool at_most_here(double a, double b, double margin) {
  std::uint64_t exact_decisions = 0;
  return exact::at_most(a, b, margin, exact_decisions);
}

TEST(BoxPredicate, EndsThatBreakRounding) {
  const std::vector<double> numbers{0.0,        -0.0,      1.0,         -1.0,
                                    0.1,        0.3,       smallest,    -smallest,
                                    0x1p-1022,  0x1p-53,   1 + 0x1p-52, 0x1p53,
                                    0x1p53 + 2, -0x1p53,   0x1p1000,    largest,
                                    -largest,   0x1p-1000, 0x1.8p52,    std::nextafter(largest, 0)};
  for (const double a : numbers) {
    for (const double b : numbers) {
      for (const double margin : numbers) {
        if (margin < 0.0) continue;
        ASSERT_EQ(at_most_here(a, b, margin), at_most_by_rationals(a, b, margin))
            << a << " <= " << b << " + " << margin;
      }
    }
  }
}

/// However many axes tie, it is one decision: Statistics counts pairs.
TEST(BoxPredicate, CountsAPairOnce) {
  const exact::Box<3> box{{0, 0, 0}, {1, 1, 1}};
  const exact::Box<3> other{{2, 2, 2}, {3, 3, 3}};
  std::uint64_t exact_decisions = 0;
  EXPECT_TRUE(exact::within_reach(box, other, 1.0, exact_decisions));
  EXPECT_EQ(exact_decisions, 1U);
  EXPECT_FALSE(exact::within_reach(box, other, 0.5, exact_decisions));
  EXPECT_EQ(exact_decisions, 1U);
}

/// Margins on and beside the rounded difference, where one bit decides.
TEST(BoxPredicate, MarginsBesideTheDifference) {
  scenes::Random random(91);
  std::uint64_t exact_decisions = 0;
  std::size_t within = 0;
  for (int k = 0; k < 100000; ++k) {
    const double a = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(60)) - 30);
    const double b = std::ldexp(random.uniform(-1.0, 1.0), static_cast<int>(random.below(60)) - 30);
    const double difference = std::fabs(a - b);
    for (const double margin :
         {difference, std::nextafter(difference, 0.0), std::nextafter(difference, largest)}) {
      const bool expected = at_most_by_rationals(a, b, margin);
      within += expected ? 1 : 0;
      ASSERT_EQ(exact::at_most(a, b, margin, exact_decisions), expected)
          << a << " <= " << b << " + " << margin;
    }
  }
  EXPECT_GT(within, 100000U);
  EXPECT_LT(within, 280000U);
  EXPECT_GT(exact_decisions, 30000U) << "ties are looked at again";
}

TEST(BoxGap, IsTheLargestSeparationRoundedOnce) {
  scenes::Random random(92);
  for (int k = 0; k < 20000; ++k) {
    exact::Box<3> box[2];
    for (auto& b : box) {
      for (int axis = 0; axis < 3; ++axis) {
        const double end[2] = {static_cast<double>(random.below(8)) / 10.0, random.uniform()};
        b.lower[axis] = std::fmin(end[0], end[1]);
        b.upper[axis] = std::fmax(end[0], end[1]);
      }
    }
    mpq_class separation = -10;
    for (int axis = 0; axis < 3; ++axis) {
      for (int first = 0; first < 2; ++first) {
        const mpq_class here =
            mpq_class(box[first].lower[axis]) - mpq_class(box[1 - first].upper[axis]);
        if (here > separation) separation = here;
      }
    }
    const double result = exact::gap(box[0], box[1]);
    ASSERT_EQ(result, exact::gap(box[1], box[0]));
    std::uint64_t exact_decisions = 0;
    ASSERT_EQ(result <= 0.0, exact::within_reach(box[0], box[1], 0.0, exact_decisions));
    const mpq_class error = abs(mpq_class(result) - separation);
    ASSERT_LE(error, abs(separation) * mpq_class(0x1p-53));
  }
}

TEST(BoxGap, StaysFiniteAndPositiveZero) {
  const exact::Box<2> left{{-largest, 0.0}, {-largest, 1.0}};
  const exact::Box<2> right{{largest, 0.0}, {largest, 1.0}};
  EXPECT_EQ(exact::gap(left, right), largest);
  const exact::Box<2> all{{-largest, -largest}, {largest, largest}};
  EXPECT_EQ(exact::gap(all, all), -largest);
  const exact::Box<2> unit{{-1.0, 0.0}, {-0.0, 1.0}};
  const exact::Box<2> next{{0.0, 0.0}, {1.0, 1.0}};
  EXPECT_EQ(exact::gap(unit, next), 0.0);
  EXPECT_FALSE(std::signbit(exact::gap(unit, next)));
  EXPECT_FALSE(std::signbit(exact::gap(next, unit)));
}

}  // namespace
}  // namespace abut::testing
