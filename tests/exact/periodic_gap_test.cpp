#include "exact/periodic_gap.hpp"

#include "exact/periodic_pairs.hpp"
#include "exact/sphere_gap.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::testing {
namespace {

constexpr double u = 0x1p-53;

template <int Dim>
double gap_of(const PeriodicPair<Dim>& pair) {
  return exact::gap(pair.spheres.a, pair.spheres.b, pair.shift, pair.lattice);
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

template <class Dimension>
class PeriodicGap : public ::testing::Test {};

TYPED_TEST_SUITE(PeriodicGap, Dimensions);

/// Finite, of the right sign, and the same bits when seen from the other element.
template <int Dim>
void expect_sound(PeriodicPair<Dim> pair) {
  pair.spheres.margin = 0.0;
  const double gap = gap_of(pair);
  ASSERT_TRUE(std::isfinite(gap)) << pair;
  ASSERT_EQ(gap <= 0.0, within_reach_by_rationals(pair)) << gap << ": " << pair;
  ASSERT_EQ(bits(gap), bits(gap_of(exchanged(pair)))) << pair;
}

/// Error of the gap in units of u * (distance + sum of radii).
template <int Dim>
double error_of_gap(const PeriodicPair<Dim>& pair) {
  mpf_class distance(0, 400);
  distance = exact_distance_squared(pair);
  distance = sqrt(distance);
  mpf_class radii(0, 400);
  radii = exact_reach(pair.spheres.a, pair.spheres.b, 0.0);
  const mpf_class error = (gap_of(pair) - (distance - radii)) / (distance + radii);
  return std::fabs(error.get_d()) / u;
}

TYPED_TEST(PeriodicGap, HasTheSignOfThePredicate) {
  Random random(61);
  for (int k = 0; k < 10000; ++k) {
    auto pair = cancelling_pair<TypeParam::value>(random, 1 + k % 31);
    if (k % 4 == 0) scale(pair, static_cast<int>(random.below(2000)) - 1050);
    ASSERT_NO_FATAL_FAILURE(expect_sound(pair));
    ASSERT_NO_FATAL_FAILURE(expect_sound(periodic_tie<TypeParam::value>(random, 1 + k % 31)));
    ASSERT_NO_FATAL_FAILURE(expect_sound(extreme_periodic_pair<TypeParam::value>(random)));
  }
}

/// However much of x and n A cancels: the difference is rounded once.
TYPED_TEST(PeriodicGap, IsAsAccurateAsInOpenSpace) {
  Random random(62);
  for (int k = 0; k < 10000; ++k) {
    auto pair = cancelling_pair<TypeParam::value>(random, 1 + k % 31);
    pair.spheres.margin = 0.0;
    if (exact_reach(pair.spheres.a, pair.spheres.b, 0.0) == 0) continue;
    ASSERT_LT(error_of_gap(pair), 4.6) << pair;
    scale(pair, static_cast<int>(random.below(1700)) - 850);
    ASSERT_LT(error_of_gap(pair), 4.6) << "scaled: " << pair;
  }
}

TYPED_TEST(PeriodicGap, WithoutAShiftIsThatOfOpenSpace) {
  Random random(63);
  for (int k = 0; k < 5000; ++k) {
    PeriodicPair<TypeParam::value> pair{};
    pair.spheres = k % 2 == 0 ? borderline_pair<TypeParam::value>(random, 10)
                              : extreme_pair<TypeParam::value>(random);
    set_lattice<TypeParam::value>(pair, extreme_number, random);
    pair.lattice.periodic = {true, true, true};
    ASSERT_EQ(bits(gap_of(pair)), bits(exact::gap(pair.spheres.a, pair.spheres.b))) << pair;
  }
}

TEST(PeriodicGapCases, PlainNumbers) {
  exact::Lattice lattice;
  lattice.vectors = {{{10, 0, 0}, {0, 20, 0}, {}}};
  lattice.periodic = {true, true, false};
  const exact::Sphere<2> a{{1, 1}, 1};
  const exact::Sphere<2> b{{8, 17}, 1};
  EXPECT_EQ(exact::gap(a, b, {-1, -1, 0}, lattice), 3.0);
  EXPECT_EQ(exact::gap(a, b, {-1, 0, 0}, lattice), std::sqrt(9.0 + 256.0) - 2.0);
  EXPECT_EQ(exact::gap(a, a, {1, 0, 0}, lattice), 8.0);
}

/// The largest numbers cancel exactly, and leave those at the other end of the range.
TEST(PeriodicGapCases, SmallNumbersStayBesideLargeOnesThatCancel) {
  constexpr double huge = std::numeric_limits<double>::max();
  exact::Lattice lattice;
  lattice.vectors[0] = {huge, 0.0, 0.0};
  lattice.periodic[0] = true;
  for (const int exponent : {-300, -900, -950, -1060}) {
    const double s = std::ldexp(1.0, exponent);
    const exact::Sphere<2> far{{huge, 0.0}, s};
    const exact::Sphere<2> near{{0.0, 7.0 * s}, 2.0 * s};
    EXPECT_EQ(exact::gap(far, near, {1, 0, 0}, lattice), 4.0 * s) << exponent;
    EXPECT_EQ(exact::gap(near, far, {-1, 0, 0}, lattice), 4.0 * s) << exponent;
  }
}

/// Multiples of two vectors cancel but for a part that is 2^-900 of them, or less.
TEST(PeriodicGapCases, SmallNumbersStayBesideVectorsThatCancel) {
  exact::Lattice lattice;
  lattice.periodic = {true, true, false};
  const exact::Sphere<2> a{{3, 11}, 1};
  const exact::Sphere<2> b{{0, 0}, 1};
  for (const int exponent : {0, 40, 60, 100, 340, 860, 900, 1010}) {
    const double length = std::ldexp(3.0, exponent);
    lattice.vectors = {{{length, 0, 0}, {384.0 * length, 7, 0}, {}}};
    EXPECT_EQ(exact::gap(a, b, {-384, 1, 0}, lattice), 3.0) << exponent;
    EXPECT_EQ(exact::gap(b, a, {384, -1, 0}, lattice), 3.0) << exponent;
  }
}

TEST(PeriodicGapCases, AGapThatNoDoubleHoldsIsTheLargest) {
  constexpr double huge = std::numeric_limits<double>::max();
  exact::Lattice lattice;
  lattice.vectors = {{{huge, 0, 0}, {}, {}}};
  lattice.periodic = {true, false, false};
  const exact::Sphere<2> a{{0, 0}, 0};
  EXPECT_EQ(exact::gap(a, a, {std::numeric_limits<std::int32_t>::max(), 0, 0}, lattice), huge);
  EXPECT_EQ(exact::gap(a, a, {1, 0, 0}, lattice), huge);
}

}  // namespace
}  // namespace abut::testing
