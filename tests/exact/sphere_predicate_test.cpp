// The predicate against rational numbers, and how often the filter leaves a pair to the slow path.

#include "exact/sphere_predicate.hpp"

#include "exact/hard_pairs.hpp"
#include "exact/rational_oracle.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

using exact::within_reach;

struct Count {
  std::uint64_t pairs = 0;
  std::uint64_t within = 0;
  std::uint64_t exact_decisions = 0;
};

/// Stops at the first pair that the library and the rational numbers decide differently.
template <int Dim>
void compare(const HardPair<Dim>& pair, Count& count) {
  const bool decided = within_reach(pair.a, pair.b, pair.margin, count.exact_decisions);
  std::uint64_t again = 0;
  ASSERT_EQ(decided, within_reach_by_rationals(pair.a, pair.b, pair.margin)) << pair;
  ASSERT_EQ(decided, exact::within_reach_exactly(pair.a, pair.b, pair.margin)) << pair;
  ASSERT_EQ(decided, within_reach(pair.b, pair.a, pair.margin, again)) << "exchanged: " << pair;
  ++count.pairs;
  count.within += decided ? 1 : 0;
}

template <class Dimension>
class SpherePredicate : public ::testing::Test {};

TYPED_TEST_SUITE(SpherePredicate, Dimensions);

TYPED_TEST(SpherePredicate, OrdinaryPairsAreDecidedByTheFilter) {
  Random random(1);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    ASSERT_NO_FATAL_FAILURE(compare(ordinary_pair<TypeParam::value>(random), count));
  }
  EXPECT_EQ(count.exact_decisions, 0u);
  EXPECT_GT(count.within, 1000u);
  EXPECT_LT(count.within, 19000u);
}

TYPED_TEST(SpherePredicate, BorderlinePairs) {
  Random random(2);
  Count count;
  for (int k = 0; k < 40000; ++k) {
    ASSERT_NO_FATAL_FAILURE(compare(borderline_pair<TypeParam::value>(random, 3), count));
  }
  EXPECT_GT(count.exact_decisions, count.pairs * 9 / 10) << "the slow path must be reached";
  EXPECT_GT(count.within, count.pairs / 4);
  EXPECT_LT(count.within, count.pairs * 3 / 4);
}

TYPED_TEST(SpherePredicate, BorderlinePairsAtEveryScale) {
  Random random(3);
  Count count;
  for (int exponent = -1074; exponent <= 1020; exponent += 6) {
    for (int k = 0; k < 40; ++k) {
      auto pair = borderline_pair<TypeParam::value>(random, 3);
      scale(pair, exponent);
      ASSERT_NO_FATAL_FAILURE(compare(pair, count)) << "2^" << exponent;
    }
  }
  EXPECT_GT(count.exact_decisions, count.pairs * 9 / 10);
}

TYPED_TEST(SpherePredicate, ExactTiesTouch) {
  Random random(4);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    const auto tie = exact_tie<TypeParam::value>(random, 1 + k % 40);
    std::uint64_t unused = 0;
    ASSERT_TRUE(within_reach(tie.a, tie.b, tie.margin, unused)) << tie;
    ASSERT_NO_FATAL_FAILURE(compare(tie, count));
    auto apart = tie;
    double& radius = apart.a.radius > 0 ? apart.a.radius : apart.b.radius;
    radius = std::nextafter(radius, 0.0);
    ASSERT_FALSE(within_reach(apart.a, apart.b, apart.margin, unused)) << apart;
    ASSERT_NO_FATAL_FAILURE(compare(apart, count));
  }
  EXPECT_GT(count.exact_decisions, count.pairs * 9 / 10);
}

TYPED_TEST(SpherePredicate, ExtremeNumbers) {
  Random random(5);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    ASSERT_NO_FATAL_FAILURE(compare(extreme_pair<TypeParam::value>(random), count));
  }
  EXPECT_GT(count.exact_decisions, 1000u);
  EXPECT_GT(count.within, 1000u);
}

TYPED_TEST(SpherePredicate, TheMarginAloneReachesToo) {
  HardPair<TypeParam::value> points{};
  points.a.center[0] = 0.1;
  points.b.center[0] = 0.4;
  // 0.4 - 0.1 in real numbers, rounded up and down.
  const double reaches = 0.4 - 0.1;
  std::uint64_t unused = 0;
  for (int ulps = -3; ulps <= 3; ++ulps) {
    const double margin = moved_by_ulps(reaches, ulps);
    EXPECT_EQ(within_reach(points.a, points.b, margin, unused),
              within_reach_by_rationals(points.a, points.b, margin))
        << ulps;
  }
  EXPECT_FALSE(within_reach(points.a, points.b, moved_by_ulps(reaches, -3), unused));
  EXPECT_TRUE(within_reach(points.a, points.b, moved_by_ulps(reaches, 3), unused));
}

TEST(SpherePredicateCases, ZeroRadiiTouchOnlyWhereTheyCoincide) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  std::uint64_t count = 0;
  EXPECT_TRUE(within_reach<2>({{0.0, -0.0}, 0.0}, {{-0.0, 0.0}, 0.0}, 0.0, count));
  EXPECT_TRUE(within_reach<2>({{1e300, 5.0}, 0.0}, {{1e300, 5.0}, -0.0}, 0.0, count));
  EXPECT_FALSE(within_reach<2>({{0.0, 0.0}, 0.0}, {{tiny, 0.0}, 0.0}, 0.0, count));
  EXPECT_TRUE(within_reach<2>({{0.0, 0.0}, 0.0}, {{tiny, 0.0}, tiny}, 0.0, count));
  EXPECT_FALSE(within_reach<2>({{0.0, 0.0}, 0.0}, {{tiny, tiny}, tiny}, 0.0, count));
  EXPECT_TRUE(within_reach<2>({{0.0, 0.0}, tiny}, {{tiny, tiny}, tiny}, 0.0, count));
  EXPECT_EQ(count, 6u) << "a reach below the filter's range is left to the slow path";
}

TEST(SpherePredicateCases, SumsThatDoNotFit) {
  constexpr double huge = std::numeric_limits<double>::max();
  std::uint64_t count = 0;
  EXPECT_TRUE(within_reach<3>({{-huge, 0, 0}, huge}, {{huge, 0, 0}, huge}, 0.0, count));
  EXPECT_FALSE(within_reach<3>({{-huge, 0, 0}, huge}, {{huge, 1.0, 0}, huge}, 0.0, count));
  EXPECT_TRUE(within_reach<3>({{-huge, 0, 0}, huge}, {{huge, 1.0, 0}, huge}, 1.0, count));
  EXPECT_FALSE(
      within_reach<3>({{-huge, -huge, -huge}, huge}, {{huge, huge, huge}, huge}, 0.0, count));
  EXPECT_TRUE(within_reach<3>({{-huge, -huge, -huge}, huge}, {{huge, huge, huge}, huge},
                              huge * 0.75, count) ==
              within_reach_by_rationals<3>({{-huge, -huge, -huge}, huge},
                                           {{huge, huge, huge}, huge}, huge * 0.75));
  EXPECT_EQ(count, 5u);
  // Clear without the slow path: the difference overflows, the reach is ordinary.
  EXPECT_FALSE(within_reach<3>({{-huge, 0, 0}, 1.0}, {{huge, 0, 0}, 1.0}, 0.0, count));
  EXPECT_EQ(count, 5u);
}

}  // namespace
}  // namespace abut::testing
