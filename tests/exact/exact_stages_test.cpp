// Each stage of the slow path by itself: it decides what it claims to decide, rightly.

#include "exact/exact_stages.hpp"

#include "exact/hard_pairs.hpp"
#include "exact/rational_oracle.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace abut::testing {
namespace {

using exact::decide_accumulated;
using exact::decide_if_nothing_rounded;
using exact::decide_in_double_double;
using exact::decide_scaled;

struct Decided {
  int by_first = 0;
  int by_second_only = 0;
  int by_third_only = 0;
};

/// Every stage that answers must be right, the third always.
template <int Dim>
void enter_each_stage(const HardPair<Dim>& pair, Decided& decided) {
  const bool expected = within_reach_by_rationals(pair.a, pair.b, pair.margin);
  const auto first = decide_if_nothing_rounded(pair.a, pair.b, pair.margin);
  const auto second = decide_scaled(pair.a, pair.b, pair.margin);
  ASSERT_EQ(first.value_or(expected), expected) << "nothing rounded: " << pair;
  ASSERT_EQ(decide_in_double_double(pair.a, pair.b, pair.margin).value_or(expected), expected)
      << "doubled precision: " << pair;
  ASSERT_EQ(second.value_or(expected), expected) << "scaled integers: " << pair;
  ASSERT_EQ(decide_accumulated(pair.a, pair.b, pair.margin), expected) << "accumulator: " << pair;
  decided.by_first += first.has_value() ? 1 : 0;
  decided.by_second_only += !first.has_value() && second.has_value() ? 1 : 0;
  decided.by_third_only += !first.has_value() && !second.has_value() ? 1 : 0;
}

/// Pairs whose coordinates were moved by a unit in the last place: nearly all are no ties any more.
template <int Dim>
void expect_near_ties_decided_by_doubled_precision(double margin) {
  Random random(21);
  int decided = 0;
  for (int k = 0; k < 5000; ++k) {
    auto pair = exact_tie<Dim>(random, 44);
    pair.a.center[0] = std::nextafter(pair.a.center[0], k % 2 == 0 ? 1e300 : -1e300);
    pair.margin += margin * pair.a.radius;
    pair.b.radius -= std::min(pair.b.radius, margin * pair.a.radius);
    const bool expected = within_reach_by_rationals(pair.a, pair.b, pair.margin);
    const auto found = decide_in_double_double(pair.a, pair.b, pair.margin);
    ASSERT_EQ(found.value_or(expected), expected) << pair;
    decided += found.has_value() ? 1 : 0;
  }
  EXPECT_GT(decided, 3500);
}

/// To a multiple of 2^-bits.
double rounded_to(double value, int bits) {
  return std::ldexp(std::round(std::ldexp(value, bits)), -bits);
}

template <class Dimension>
class ExactStages : public ::testing::Test {};

TYPED_TEST_SUITE(ExactStages, Dimensions);

TYPED_TEST(ExactStages, ShortTiesAreDecidedByTheFirst) {
  Random random(11);
  Decided decided;
  for (int k = 0; k < 5000; ++k) {
    // Factors of at most 12 bits times numbers of at most 5.
    ASSERT_NO_FATAL_FAILURE(enter_each_stage(exact_tie<TypeParam::value>(random, 12), decided));
  }
  EXPECT_EQ(decided.by_first, 5000);
}

TYPED_TEST(ExactStages, NearTiesAreDecidedInDoubledPrecision) {
  expect_near_ties_decided_by_doubled_precision<TypeParam::value>(0.0);
  expect_near_ties_decided_by_doubled_precision<TypeParam::value>(0x1p-3);
}

TYPED_TEST(ExactStages, LongTiesAreDecidedByTheSecond) {
  Random random(12);
  Decided decided;
  for (int k = 0; k < 5000; ++k) {
    ASSERT_NO_FATAL_FAILURE(enter_each_stage(exact_tie<TypeParam::value>(random, 44), decided));
  }
  EXPECT_GT(decided.by_second_only, 4500);
}

TYPED_TEST(ExactStages, NumbersOfVeryDifferentSizeAreDecidedByTheThird) {
  Random random(13);
  Decided decided;
  for (int k = 0; k < 5000; ++k) {
    auto pair = exact_tie<TypeParam::value>(random, 20);
    // What is added is far below the last place of everything else, yet decides.
    const double grain = std::ldexp(pair.a.radius + pair.b.radius, -300);
    ASSERT_GT(grain, 0.0);
    if (k % 2 == 0) {
      pair.margin = grain;
    } else {
      // The same differences, which are not negative, each grown by the grain.
      for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
        pair.a.center[axis] -= pair.b.center[axis];
        pair.b.center[axis] = -grain;
      }
    }
    ASSERT_NO_FATAL_FAILURE(enter_each_stage(pair, decided));
    ASSERT_EQ(decide_accumulated(pair.a, pair.b, pair.margin), k % 2 == 0) << pair;
  }
  EXPECT_EQ(decided.by_third_only, 5000);
}

TYPED_TEST(ExactStages, BorderlineAndExtremePairs) {
  Random random(14);
  Decided decided;
  for (int k = 0; k < 20000; ++k) {
    auto pair = borderline_pair<TypeParam::value>(random, 2);
    if (k % 2 == 0) scale(pair, static_cast<int>(random.below(2000)) - 1050);
    ASSERT_NO_FATAL_FAILURE(enter_each_stage(pair, decided));
    ASSERT_NO_FATAL_FAILURE(enter_each_stage(extreme_pair<TypeParam::value>(random), decided));
  }
  EXPECT_GT(decided.by_second_only, 1000);
  EXPECT_GT(decided.by_third_only, 1000);
}

TYPED_TEST(ExactStages, TheFirstIsRightWhereNumbersAreAboutAsLongAsItTakes) {
  Random random(15);
  Decided decided;
  for (int k = 0; k < 20000; ++k) {
    auto pair = borderline_pair<TypeParam::value>(random, 0);
    const int bits = 20 + k % 12;
    for (exact::Sphere<TypeParam::value>* sphere : {&pair.a, &pair.b}) {
      for (double& x : sphere->center) x = rounded_to(x, bits);
      sphere->radius = rounded_to(sphere->radius, bits);
    }
    pair.margin = rounded_to(pair.margin, bits);
    ASSERT_NO_FATAL_FAILURE(enter_each_stage(pair, decided));
  }
  EXPECT_GT(decided.by_first, 1000);
  EXPECT_GT(decided.by_second_only, 1000);
}

TYPED_TEST(ExactStages, TheFirstAcceptsCoordinatesThatAreZero) {
  HardPair<TypeParam::value> pair{};
  pair.a.center[0] = 1.0;
  pair.a.radius = pair.b.radius = 0.5;
  for (const double zero : {0.0, -0.0}) {
    pair.b.center[0] = pair.b.center[1] = zero;
    EXPECT_EQ(decide_if_nothing_rounded(pair.a, pair.b, 0.0), std::optional(true)) << zero;
  }
}

TEST(ExactStagesCases, TheFirstRefusesWhatRounds) {
  const auto refused = [](const exact::Sphere<2>& a, const exact::Sphere<2>& b, double margin) {
    return !decide_if_nothing_rounded(a, b, margin).has_value();
  };
  EXPECT_FALSE(refused({{3, 4}, 2}, {{0, 0}, 3}, 0));
  EXPECT_TRUE(refused({{1, 0}, 0x1p-60}, {{0, 0}, 1}, 0)) << "sum of radii";
  EXPECT_TRUE(refused({{1, 0}, 0.5}, {{0, 0}, 0.5}, 0x1p-60)) << "margin";
  EXPECT_TRUE(refused({{1, 0}, 0.5}, {{0x1p-60, 0}, 0.5}, 0)) << "difference";
  EXPECT_TRUE(refused({{1, 0x1p-30}, 0.5}, {{0, 0}, 0.5}, 0)) << "sum of squares";
  EXPECT_TRUE(refused({{1 + 0x1p-26, 0}, 0.5}, {{0, 0}, 0.5}, 0)) << "square of 27 bits";
  EXPECT_FALSE(refused({{1 + 0x1p-25, 0}, 0.5}, {{0, 0}, 0.5}, 0)) << "square of 26 bits";
  EXPECT_TRUE(refused({{0x1p-540, 0}, 0x1p-540}, {{0, 0}, 0}, 0)) << "underflow";
  EXPECT_TRUE(refused({{0x1p600, 0}, 1}, {{0, 0}, 1}, 0)) << "overflow";
  EXPECT_TRUE(refused({{0x1p1023, 0}, 1}, {{-0x1p1023, 0}, 1}, 0)) << "overflow of a difference";
}

TEST(ExactStagesCases, TheSecondTakes61BitsAndNotMore) {
  const auto taken = [](double large, double small) {
    return decide_scaled<2>({{large, 0}, 0}, {{0, small}, 0}, 0).has_value();
  };
  EXPECT_TRUE(taken(0x1.8p60, 1.0));
  EXPECT_TRUE(taken(-0x1.8p60, 1.0));
  EXPECT_FALSE(taken(0x1p61, 1.0));
  EXPECT_TRUE(taken(0x1p-1014, 0x1p-1074));
  EXPECT_FALSE(taken(0x1p-1013, 0x1p-1074));
  EXPECT_TRUE(taken(0.0, 0.0));
  // The largest numbers that fit, everywhere at once.
  const double most = 0x1.fffffffffffffp60;
  const exact::Sphere<3> a{{most, most, most}, most};
  const exact::Sphere<3> b{{-most, -most, -most}, most};
  EXPECT_EQ(decide_scaled(a, b, most), std::optional(within_reach_by_rationals(a, b, most)));
  EXPECT_EQ(decide_scaled(a, b, 0x1p8), std::optional(within_reach_by_rationals(a, b, 0x1p8)));
}

}  // namespace
}  // namespace abut::testing
