#include "exact/sphere_gap.hpp"

#include "exact/hard_pairs.hpp"
#include "exact/rational_oracle.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

constexpr double u = 0x1p-53;

template <class Dimension>
class SphereGap : public ::testing::Test {};

TYPED_TEST_SUITE(SphereGap, Dimensions);

/// Finite, of the right sign, and the same bits when the two are exchanged.
template <int Dim>
void expect_sound(const HardPair<Dim>& pair) {
  const double gap = exact::gap(pair.a, pair.b);
  ASSERT_TRUE(std::isfinite(gap)) << pair;
  ASSERT_EQ(gap <= 0.0, within_reach_by_rationals(pair.a, pair.b, 0.0)) << gap << ": " << pair;
  const double exchanged = exact::gap(pair.b, pair.a);
  ASSERT_EQ(std::bit_cast<std::uint64_t>(gap), std::bit_cast<std::uint64_t>(exchanged)) << pair;
}

/// The real gap in 400 bits.
template <int Dim>
mpf_class real_gap(const HardPair<Dim>& pair) {
  mpf_class distance(0, 400);
  mpf_class square(0, 400);
  square = exact_distance_squared(pair.a, pair.b);
  distance = sqrt(square);
  mpf_class reach(0, 400);
  reach = exact_reach(pair.a, pair.b, 0.0);
  return distance - reach;
}

/// Error of the gap in units of u * (distance + sum of radii).
template <int Dim>
double error_of_gap(const HardPair<Dim>& pair) {
  const mpf_class real = real_gap(pair);
  mpf_class reach(0, 400);
  reach = exact_reach(pair.a, pair.b, 0.0);
  const mpf_class error = (exact::gap(pair.a, pair.b) - real) / (real + 2 * reach);
  return std::fabs(error.get_d()) / u;
}

TYPED_TEST(SphereGap, HasTheSignOfThePredicate) {
  Random random(41);
  int of_zero_width = 0;
  for (int k = 0; k < 20000; ++k) {
    auto pair = borderline_pair<TypeParam::value>(random, 3);
    pair.margin = 0.0;
    if (k % 4 == 0) scale(pair, static_cast<int>(random.below(2000)) - 1050);
    ASSERT_NO_FATAL_FAILURE(expect_sound(pair));
    const double gap = exact::gap(pair.a, pair.b);
    of_zero_width += gap == 0.0 || gap == std::numeric_limits<double>::denorm_min() ? 1 : 0;
  }
  EXPECT_GT(of_zero_width, 100) << "the sign must have been corrected now and then";
}

TYPED_TEST(SphereGap, IsSoundOnTiesAndExtremeNumbers) {
  Random random(42);
  for (int k = 0; k < 20000; ++k) {
    ASSERT_NO_FATAL_FAILURE(expect_sound(exact_tie<TypeParam::value>(random, 1 + k % 40)));
    ASSERT_NO_FATAL_FAILURE(expect_sound(extreme_pair<TypeParam::value>(random)));
  }
}

TYPED_TEST(SphereGap, ExactTiesHaveNoGap) {
  Random random(43);
  for (int k = 0; k < 2000; ++k) {
    const auto tie = exact_tie<TypeParam::value>(random, 12);
    ASSERT_EQ(exact::gap(tie.a, tie.b), 0.0) << tie;
  }
}

TYPED_TEST(SphereGap, IsAccurate) {
  // sqrt halves the 5.01 u of the square and adds u; the sum of radii and the subtraction add u
  // each: less than 4.6 u (D + S).
  Random random(44);
  for (int k = 0; k < 10000; ++k) {
    auto pair = k % 2 == 0 ? ordinary_pair<TypeParam::value>(random)
                           : borderline_pair<TypeParam::value>(random, 100);
    pair.margin = 0.0;
    if (exact_reach(pair.a, pair.b, 0.0) == 0) continue;
    ASSERT_LT(error_of_gap(pair), 4.6) << pair;
    scale(pair, static_cast<int>(random.below(1800)) - 900);
    if (pair.a.radius > 0 && pair.a.radius < 0x1p-1000) continue;
    ASSERT_LT(error_of_gap(pair), 4.6) << "scaled: " << pair;
  }
}

TYPED_TEST(SphereGap, IsAccurateRelativeToItselfWhereNothingCancels) {
  Random random(45);
  for (int k = 0; k < 5000; ++k) {
    HardPair<TypeParam::value> far = ordinary_pair<TypeParam::value>(random);
    far.a.center[0] += 100.0;
    const mpf_class real = real_gap(far);
    const mpf_class error = (exact::gap(far.a, far.b) - real) / real;
    ASSERT_LT(std::fabs(error.get_d()), 6 * u) << far;
  }
}

TEST(SphereGapCases, PlainNumbers) {
  EXPECT_EQ(exact::gap<2>({{0, 0}, 1}, {{3, 4}, 1}), 3.0);
  EXPECT_EQ(exact::gap<2>({{0, 0}, 4}, {{3, 4}, 1}), 0.0);
  EXPECT_EQ(exact::gap<2>({{0, 0}, 4}, {{3, 4}, 4}), -3.0);
  EXPECT_EQ(exact::gap<3>({{1, 1, 1}, 2}, {{1, 1, 1}, 0.5}), -2.5);
  EXPECT_EQ(exact::gap<3>({{1, 1, 1}, 0}, {{1, 1, 1}, 0}), 0.0);
}

TEST(SphereGapCases, NoGapIsNeverNegativeZero) {
  // sqrt(3) - 2 smallest doubles: less than half of one below zero.
  const exact::Sphere<3> a{{0.0, 0.0, 0.0}, 0x1p-1074};
  const exact::Sphere<3> b{{0x1p-1074, 0x1p-1074, 0x1p-1074}, 0x1p-1074};
  EXPECT_FALSE(std::signbit(exact::gap(a, b)));
  EXPECT_EQ(exact::gap(a, b), 0.0);
}

TEST(SphereGapCases, AGapThatNoDoubleHoldsIsTheLargest) {
  constexpr double huge = std::numeric_limits<double>::max();
  EXPECT_EQ(exact::gap<2>({{-huge, 0}, 0}, {{huge, 0}, 0}), huge);
  EXPECT_EQ(exact::gap<2>({{0, 0}, huge}, {{0, 0}, huge}), -huge);
}

}  // namespace
}  // namespace abut::testing
