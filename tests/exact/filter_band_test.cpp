// The band of the filter: never wrong outside, not wider than it must be, and narrower ones fail.

#include "exact/exact_stages.hpp"
#include "exact/hard_pairs.hpp"
#include "exact/rational_oracle.hpp"
#include "exact/sphere_predicate.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace abut::testing {
namespace {

constexpr double u = 0x1p-53;

template <int Dim>
double computed_distance_squared(const HardPair<Dim>& pair) {
  double sum = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double difference = pair.a.center[axis] - pair.b.center[axis];
    sum += difference * difference;
  }
  return sum;
}

/// The filter of the library with another band.
template <int Dim>
std::optional<bool> filter(const HardPair<Dim>& pair, double band) {
  const double distance_squared = computed_distance_squared(pair);
  const double reach = pair.a.radius + pair.b.radius + pair.margin;
  if (distance_squared > reach * reach * (1.0 + band)) return false;
  if (distance_squared < reach * reach * (1.0 - band)) return true;
  return std::nullopt;
}

/// How far the computed square is from the real one, in units of u.
template <int Dim>
double error_of_square(const HardPair<Dim>& pair) {
  const mpq_class exact = exact_distance_squared(pair.a, pair.b);
  const mpq_class error = mpq_class(computed_distance_squared(pair)) - exact;
  return mpq_class(error / exact).get_d() / u;
}

/// Centres close to a power of two, where rounding weighs most, far more finely told apart.
template <int Dim>
HardPair<Dim> coarse_pair(Random& random) {
  HardPair<Dim> pair{};
  for (int axis = 0; axis < Dim; ++axis) {
    const int small = static_cast<int>(random.below(3));
    pair.a.center[axis] = 1.0 + random.uniform(0.0, 0.5) * std::ldexp(1.0, -4 * small);
    pair.b.center[axis] = random.uniform(-0x1p-3, 0x1p-3) * std::ldexp(1.0, -8 * small);
  }
  return pair;
}

/// Climbs by changing one number at a time, to the largest error in the direction of `sign`.
template <int Dim>
HardPair<Dim> climb(HardPair<Dim> pair, double sign, Random& random, int steps) {
  double best = sign * error_of_square(pair);
  for (int step = 0; step < steps; ++step) {
    auto changed = pair;
    exact::Sphere<Dim>& sphere = random.below(2) == 0 ? changed.a : changed.b;
    double& x = sphere.center[random.below(Dim)];
    x *= 1.0 + random.uniform(-1.0, 1.0) * std::ldexp(1.0, -static_cast<int>(random.below(40)));
    const double error = sign * error_of_square(changed);
    if (error <= best) continue;
    best = error;
    pair = changed;
  }
  return pair;
}

template <class Dimension>
class FilterBand : public ::testing::Test {};

TYPED_TEST_SUITE(FilterBand, Dimensions);

TYPED_TEST(FilterBand, IsNeverWrongNearTheReach) {
  constexpr int dim = TypeParam::value;
  Random random(21);
  std::uint64_t undecided = 0;
  std::uint64_t within = 0;
  constexpr int pairs = 1000000;
  for (int k = 0; k < pairs; ++k) {
    const auto pair = borderline_pair<dim>(random, 24);
    const std::uint64_t before = undecided;
    const bool decided = exact::within_reach(pair.a, pair.b, pair.margin, undecided);
    within += decided ? 1 : 0;
    ASSERT_EQ(decided, exact::decide_accumulated(pair.a, pair.b, pair.margin)) << pair;
    ASSERT_EQ(undecided > before, !filter(pair, exact::band).has_value())
        << "this test's copy of the filter is not the library's: " << pair;
  }
  // Reaches up to 24 units in the last place off leave both kinds in plenty.
  EXPECT_GT(undecided, pairs / 10u);
  EXPECT_LT(undecided, pairs * 9u / 10u);
  EXPECT_GT(within, pairs / 4u);
}

TYPED_TEST(FilterBand, SquaresAreOffByLessThanTheProofSays) {
  constexpr int dim = TypeParam::value;
  Random random(22);
  double worst = 0.0;
  for (int start = 0; start < 60; ++start) {
    for (const double sign : {1.0, -1.0}) {
      const auto pair = climb(coarse_pair<dim>(random), sign, random, 300);
      const double error = std::fabs(error_of_square(pair));
      ASSERT_LT(error, 5.01) << pair;
      worst = std::max(worst, error);
    }
  }
  // The search is adversarial: it comes within reach of the bound. In 2D one sum less rounds.
  EXPECT_GT(worst, dim == 2 ? 2.9 : 3.1) << worst;
}

TYPED_TEST(FilterBand, HoldsWhereTheSquaresAreWorst) {
  constexpr int dim = TypeParam::value;
  Random random(23);
  std::uint64_t wrong_with_narrow_band = 0;
  for (int start = 0; start < 40; ++start) {
    auto pair = climb(coarse_pair<dim>(random), start % 2 == 0 ? 1.0 : -1.0, random, 200);
    const double distance = std::sqrt(computed_distance_squared(pair));
    for (int k = 0; k < 10000; ++k) {
      share_out(pair, moved_by_ulps(distance, static_cast<int>(random.below(41)) - 20), random);
      const bool exact = exact::decide_accumulated(pair.a, pair.b, pair.margin);
      const auto decided = filter(pair, exact::band);
      ASSERT_EQ(decided.value_or(exact), exact) << pair;
      const auto narrow = filter(pair, 4 * u);
      wrong_with_narrow_band += narrow.value_or(exact) != exact ? 1 : 0;
    }
  }
  EXPECT_GT(wrong_with_narrow_band, 0u) << "these pairs would not find a band that is too narrow";
}

TYPED_TEST(FilterBand, DecidesWhatIsClear) {
  constexpr int dim = TypeParam::value;
  Random random(24);
  std::uint64_t clear = 0;
  for (int k = 0; k < 40000; ++k) {
    const auto pair = borderline_pair<dim>(random, 80);
    const mpq_class reach = exact_reach(pair.a, pair.b, pair.margin);
    if (reach < 0x1p-480) continue;  // the filter abstains there
    const mpq_class distance_squared = exact_distance_squared(pair.a, pair.b);
    const double off = mpq_class(distance_squared / (reach * reach) - 1).get_d() / u;
    if (std::fabs(off) < 32.0) continue;
    ++clear;
    std::uint64_t undecided = 0;
    static_cast<void>(exact::within_reach(pair.a, pair.b, pair.margin, undecided));
    ASSERT_EQ(undecided, 0u) << off << " u off: " << pair;
  }
  EXPECT_GT(clear, 10000u);
}

TYPED_TEST(FilterBand, AbstainsOutsideItsRange) {
  constexpr int dim = TypeParam::value;
  HardPair<dim> pair{};
  pair.b.center[0] = 0x1p-481;
  for (const auto& [radius, expected] :
       {std::pair{0x1p-480, 0u}, {0x1.fffffffffffffp-481, 1u}, {0x1p500, 0u}, {0x1.001p500, 1u}}) {
    pair.a.radius = radius;
    std::uint64_t undecided = 0;
    EXPECT_TRUE(exact::within_reach(pair.a, pair.b, 0.0, undecided));
    EXPECT_EQ(undecided, expected) << radius;
  }
}

}  // namespace
}  // namespace abut::testing
