// The predicate with a lattice against rational numbers.

#include "exact/periodic_predicate.hpp"

#include "exact/far_images.hpp"
#include "exact/periodic_pairs.hpp"
#include "exact/periodic_stages.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace abut::testing {
namespace {

struct Count {
  std::uint64_t pairs = 0;
  std::uint64_t within = 0;
  std::uint64_t exact_decisions = 0;
  std::uint64_t with_exact_difference = 0;
  std::uint64_t doubled = 0;
  std::uint64_t far = 0;
};

template <int Dim>
bool decide(const PeriodicPair<Dim>& pair, std::uint64_t& exact_decisions) {
  return exact::within_reach(pair.spheres.a, pair.spheres.b, pair.shift, pair.lattice,
                             pair.spheres.margin, exact_decisions);
}

/// Stops at the first pair that some stage decides otherwise than the rational numbers.
template <int Dim>
void compare(const PeriodicPair<Dim>& pair, Count& count) {
  const auto& [a, b, margin] = pair.spheres;
  const bool expected = within_reach_by_rationals(pair);
  std::uint64_t again = 0;
  ASSERT_EQ(decide(pair, count.exact_decisions), expected) << pair;
  ASSERT_EQ(decide(exchanged(pair), again), expected) << "exchanged: " << pair;
  const exact::LatticeSteps<Dim> steps(pair.shift, pair.lattice);
  ASSERT_EQ(exact::decide_accumulated(a, b, steps, margin), expected) << pair;
  const auto with_exact_difference = exact::decide_if_difference_is_exact(a, b, steps, margin);
  ASSERT_EQ(with_exact_difference.value_or(expected), expected) << pair;
  const auto doubled = exact::decide_in_double_double(a, b, steps, margin);
  ASSERT_EQ(doubled.value_or(expected), expected) << pair;
  for (const int bits : {0, 61, 92}) {
    const auto far = by_shorter_vectors(pair.lattice, pair.shift, bits);
    if (!far) continue;
    ASSERT_EQ(exact::far_image_within_reach(a, b, far->shift, far->lattice, margin), expected)
        << pair << " by " << bits << " bits";
    ++count.far;
  }
  count.with_exact_difference += with_exact_difference.has_value() ? 1 : 0;
  count.doubled += doubled.has_value() ? 1 : 0;
  count.within += expected ? 1 : 0;
  ++count.pairs;
}

template <class Dimension>
class PeriodicPredicate : public ::testing::Test {};

TYPED_TEST_SUITE(PeriodicPredicate, Dimensions);

TYPED_TEST(PeriodicPredicate, CancellationAtEveryNumberOfCells) {
  Random random(71);
  for (const int bits : {1, 4, 10, 20, 31}) {
    Count count;
    for (int k = 0; k < 4000; ++k) {
      ASSERT_NO_FATAL_FAILURE(compare(cancelling_pair<TypeParam::value>(random, bits), count))
          << bits << " bits";
    }
    EXPECT_GT(count.exact_decisions, count.pairs / 2) << "the slow path must be reached";
    EXPECT_GT(count.within, count.pairs / 5) << bits;
    EXPECT_LT(count.within, count.pairs * 4 / 5) << bits;
    EXPECT_GT(count.with_exact_difference, count.pairs / 10) << bits;
    EXPECT_LT(count.with_exact_difference, count.pairs) << bits;
    EXPECT_GT(count.doubled, count.pairs / 4) << bits;
    EXPECT_EQ(count.far, count.pairs * 3) << bits;
  }
}

TYPED_TEST(PeriodicPredicate, CancellationAtEveryScale) {
  Random random(72);
  Count count;
  for (int exponent = -1074; exponent <= 980; exponent += 6) {
    for (int k = 0; k < 20; ++k) {
      auto pair = cancelling_pair<TypeParam::value>(random, 1 + static_cast<int>(random.below(31)));
      scale(pair, exponent);
      ASSERT_NO_FATAL_FAILURE(compare(pair, count)) << "2^" << exponent;
    }
  }
  EXPECT_GT(count.exact_decisions, count.pairs / 2);
}

TYPED_TEST(PeriodicPredicate, ExactTiesTouch) {
  Random random(73);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    const auto tie = periodic_tie<TypeParam::value>(random, 1 + k % 31);
    ASSERT_NO_FATAL_FAILURE(compare(tie, count));
  }
  // Where adding n A back rounds, the tie is lost.
  EXPECT_GT(count.within, count.pairs * 9 / 10);
  EXPECT_GT(count.with_exact_difference, count.pairs * 3 / 4);
}

TYPED_TEST(PeriodicPredicate, ExtremeNumbers) {
  Random random(74);
  Count count;
  for (int k = 0; k < 20000; ++k) {
    ASSERT_NO_FATAL_FAILURE(compare(extreme_periodic_pair<TypeParam::value>(random), count));
  }
  EXPECT_GT(count.within, 1000u);
  EXPECT_LT(count.within, count.pairs);
}

TYPED_TEST(PeriodicPredicate, TheFilterDecidesWhatIsClear) {
  Random random(75);
  Count count;
  for (int k = 0; k < 10000; ++k) {
    auto pair = cancelling_pair<TypeParam::value>(random, 4);
    pair.spheres.a.radius *= random.below(2) == 0 ? 0.999 : 1.001;
    pair.spheres.a.radius += 1e-9;
    ASSERT_NO_FATAL_FAILURE(compare(pair, count));
  }
  EXPECT_EQ(count.exact_decisions, 0u);
}

TYPED_TEST(PeriodicPredicate, VectorsOfOpenAxesMeanNothing) {
  constexpr int dim = TypeParam::value;
  PeriodicPair<dim> pair{};
  pair.spheres.b.center[0] = 10.0;
  pair.spheres.a.radius = pair.spheres.b.radius = 0.5;
  pair.lattice.vectors[0] = {9.0, 0.0, 0.0};
  pair.lattice.vectors[1] = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0};
  pair.lattice.periodic[0] = true;
  std::uint64_t undecided = 0;
  pair.shift = {-1, 5, 0};
  EXPECT_TRUE(decide(pair, undecided));
  pair.shift = {0, 5, 0};
  EXPECT_FALSE(decide(pair, undecided));
  pair.lattice.periodic[0] = false;
  pair.shift = {-1, 0, 0};
  EXPECT_FALSE(decide(pair, undecided));
}

TYPED_TEST(PeriodicPredicate, TheLargestShifts) {
  constexpr int dim = TypeParam::value;
  for (const std::int32_t number :
       {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max()}) {
    PeriodicPair<dim> pair{};
    pair.lattice.vectors[0] = {1.0, 0.0, 0.0};
    pair.lattice.periodic[0] = true;
    pair.shift.x = number;
    pair.spheres.a.center[0] = 0.25;
    pair.spheres.b.center[0] = 0.75 - number;
    pair.spheres.a.radius = pair.spheres.b.radius = 0.25;
    std::uint64_t undecided = 0;
    EXPECT_TRUE(decide(pair, undecided)) << pair;
    pair.spheres.a.radius = std::nextafter(0.25, 0.0);
    EXPECT_FALSE(decide(pair, undecided)) << pair;
    EXPECT_EQ(undecided, 2u);
  }
}

/// (2 k^2)^2 + (2 k)^2 = (2 k^2 + 1)^2 - 1 and (2 k^2 - 1)^2 + (2 k)^2 = (2 k^2)^2 + 1: distances
/// that differ from the reach by ever fewer parts of themselves.
TYPED_TEST(PeriodicPredicate, NearlyTouching) {
  constexpr int dim = TypeParam::value;
  bool doubled_answered = true;
  for (int exponent = 1; exponent <= 25; ++exponent) {
    const double k = std::ldexp(1.0, exponent) - 1.0;
    for (const bool touching : {true, false}) {
      PeriodicPair<dim> pair{};
      pair.lattice.vectors[0] = {8.0, 0.0, 0.0};
      pair.lattice.periodic[0] = true;
      pair.shift.x = -5;
      pair.spheres.a.center[0] = (touching ? 2 * k * k : 2 * k * k - 1) - 40.0;
      pair.spheres.a.center[1] = 2 * k;
      pair.spheres.a.radius = touching ? 2 * k * k + 1 : 2 * k * k;
      Count count;
      ASSERT_NO_FATAL_FAILURE(compare(pair, count));
      EXPECT_EQ(count.within, touching ? 1u : 0u);
      EXPECT_TRUE(count.doubled == 1 || exponent >= 20) << exponent;
      doubled_answered = count.doubled == 1;
    }
  }
  EXPECT_FALSE(doubled_answered) << "of 2^-102, doubled precision must not say anything";
}

/// The filter with another band, to see that these pairs need the one it has.
template <int Dim>
std::optional<bool> filter(const PeriodicPair<Dim>& pair, double band) {
  const auto& [a, b, margin] = pair.spheres;
  const double reach = a.radius + b.radius + margin;
  double magnitude = reach;
  double square = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    double difference = a.center[axis] - b.center[axis];
    magnitude += std::fabs(a.center[axis]) + std::fabs(b.center[axis]);
    for (const auto& step : exact::LatticeSteps<Dim>(pair.shift, pair.lattice)) {
      difference -= step.number * step.vector[axis];
      magnitude += std::fabs(step.number * step.vector[axis]);
    }
    square += difference * difference;
  }
  const double outer = reach + band * magnitude;
  const double inner = std::fmax(0.0, reach - band * magnitude);
  if (square > outer * outer) return false;
  if (square < inner * inner) return true;
  return std::nullopt;
}

TYPED_TEST(PeriodicPredicate, ANarrowerBandWouldBeWrong) {
  Random random(76);
  std::uint64_t wrong = 0;
  for (int k = 0; k < 60000; ++k) {
    const auto pair = cancelling_pair<TypeParam::value>(random, 6);
    const exact::LatticeSteps<TypeParam::value> steps(pair.shift, pair.lattice);
    if (steps.empty()) continue;
    const bool exact =
        exact::decide_accumulated(pair.spheres.a, pair.spheres.b, steps, pair.spheres.margin);
    std::uint64_t undecided = 0;
    ASSERT_EQ(decide(pair, undecided), exact) << pair;
    ASSERT_EQ(undecided == 0, filter(pair, exact::absolute_band).has_value())
        << "this test's copy of the filter is not the library's: " << pair;
    wrong += filter(pair, exact::absolute_band / 16).value_or(exact) != exact ? 1 : 0;
  }
  EXPECT_GT(wrong, 0u);
}

}  // namespace
}  // namespace abut::testing
