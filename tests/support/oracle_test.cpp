// The oracle itself, on systems worked by hand.

#include "support/oracle.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace abut::testing {
namespace {

TEST(Oracle, PythagoreanDiscsTouch) {
  const auto scene = scene_of(2, {{0, 0, 0, 2}, {3, 4, 0, 3}, {3, 4 + 0x1p-50, 0, 3}});
  EXPECT_EQ(oracle_pairs(scene), (PairVector{{0, 1}, {1, 2}}));
}

TEST(Oracle, MarginCountsAndTouchingIncludesEquality) {
  const auto scene = scene_of(3, {{0, 0, 0, 1}, {0, 0, 2.5, 1}, {0, 7, 0, 0}});
  EXPECT_TRUE(oracle_pairs(scene, 0.0).empty());
  EXPECT_EQ(oracle_pairs(scene, 0.5), (PairVector{{0, 1}}));
  EXPECT_TRUE(oracle_pairs(scene, std::nextafter(0.5, 0.0)).empty());
}

TEST(Oracle, DecidesWhereSquaresLeaveTheRange) {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  const auto small = scene_of(2, {{0, 0, 0, tiny}, {3 * tiny, 0, 0, tiny}, {5 * tiny, 0, 0, tiny}});
  EXPECT_EQ(oracle_pairs(small), (PairVector{{1, 2}}));
  const auto large = scene_of(2, {{-1e308, 0, 0, 1.5e308}, {1.7e308, 0, 0, 1.2e308}});
  EXPECT_EQ(oracle_pairs(large), (PairVector{{0, 1}}));
}

TEST(Oracle, FilterAndRationalsAgree) {
  const auto scene = scenes::scene_named("at_reach").make(60, 5);
  PairVector rational;
  for (ElementIndex i = 0; i < 60; ++i) {
    for (ElementIndex j = i + 1; j < 60; ++j) {
      if (rational_contact(scene, i, j, 0.0)) rational.push_back({i, j});
    }
  }
  EXPECT_EQ(oracle_pairs(scene), rational);
}

TEST(SamePairs, TellsMissingWrongAndRepeated) {
  const PairVector expected{{0, 1}, {2, 3}};
  EXPECT_TRUE(same_pairs(expected, PairVector{{2, 3}, {0, 1}}));
  const auto result = same_pairs(expected, PairVector{{0, 1}, {0, 1}, {1, 2}});
  EXPECT_FALSE(result);
  EXPECT_STREQ(result.message(),
               "2 pairs expected, 3 found; 1 repeated: (0, 1); 1 missing: (2, 3); "
               "1 that should not be there: (1, 2)");
  EXPECT_FALSE(same_canonical_pairs(expected, PairVector{{2, 3}, {0, 1}}));
}

}  // namespace
}  // namespace abut::testing
