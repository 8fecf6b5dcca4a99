#include "engine/sizes/size_cut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <utility>

namespace abut::testing {
namespace {

engine::RadiusHistogram histogram_of(std::initializer_list<std::pair<double, int>> radii) {
  engine::RadiusHistogram histogram;
  for (const auto& [radius, count] : radii) {
    for (int k = 0; k < count; ++k) histogram.add(radius);
  }
  return histogram;
}

TEST(RadiusHistogram, ClassesAreHalfAnOctaveWide) {
  EXPECT_EQ(engine::RadiusHistogram::class_of(1.0), engine::RadiusHistogram::class_of(1.49));
  EXPECT_NE(engine::RadiusHistogram::class_of(1.49), engine::RadiusHistogram::class_of(1.5));
  EXPECT_NE(engine::RadiusHistogram::class_of(1.99), engine::RadiusHistogram::class_of(2.0));
  EXPECT_EQ(engine::RadiusHistogram::upper_end(engine::RadiusHistogram::class_of(1.0)), 1.5);
  EXPECT_EQ(engine::RadiusHistogram::upper_end(engine::RadiusHistogram::class_of(1.5)), 2.0);
  for (const double radius : {0.0, 0x1p-1074, 0x1p-1022, 0x1.fffffffffffffp+1023}) {
    EXPECT_LT(engine::RadiusHistogram::class_of(radius), engine::RadiusHistogram::classes);
    EXPECT_GT(engine::RadiusHistogram::upper_end(engine::RadiusHistogram::class_of(radius)),
              radius);
  }
}

template <int Dim>
std::optional<double> size_cut(const engine::RadiusHistogram& histogram,
                               const engine::SizeDistribution& sizes) {
  return engine::plan_sizes<Dim>({histogram, sizes}, sizes).cut;
}

template <int Dim>
void expect_a_cut_between(double small, double large, int smalls, int larges) {
  const auto histogram = histogram_of({{small, smalls}, {large, larges}});
  // Dense: the small ones alone fill the box.
  const double volume = smalls * std::pow(small / large, Dim) + larges;
  const auto cut = size_cut<Dim>(histogram, {large, small, 0.0, volume});
  ASSERT_TRUE(cut.has_value());
  EXPECT_GT(*cut, small);
  EXPECT_LE(*cut, large);
}

TEST(SizeCut, FewLargeOnesAreTakenOut) {
  expect_a_cut_between<2>(1.0, 64.0, 100000, 10);
  expect_a_cut_between<3>(1.0, 64.0, 100000, 10);
  expect_a_cut_between<2>(1e-200, 1e-190, 50000, 1);
  expect_a_cut_between<3>(1e-3, 1e9, 100000, 1);
}

TEST(SizeCut, NoneWhereSizesAreMuchTheSame) {
  for (const double large : {1.0, 1.2, 1.6}) {
    const auto histogram = histogram_of({{1.0, 5000}, {large, 5000}});
    EXPECT_FALSE(size_cut<2>(histogram, {large, 1.0, 0.0, 5000.0}));
    EXPECT_FALSE(size_cut<3>(histogram, {large, 1.0, 0.0, 5000.0}));
  }
}

TEST(SizeCut, NoneWhereTheMarginIsTheReach) {
  const auto histogram = histogram_of({{1e-6, 50000}, {1e-3, 50}});
  EXPECT_FALSE(size_cut<3>(histogram, {1e-3, 1e-6, 1.0, 50000.0}));
}

TEST(SizeCut, NoneForAFewElements) {
  const auto histogram = histogram_of({{1.0, 10}, {100.0, 2}});
  EXPECT_FALSE(size_cut<3>(histogram, {100.0, 1.0, 0.0, 1000.0}));
}

TEST(SizeCut, ACutLeavesElementsOnBothSides) {
  engine::RadiusHistogram histogram;
  for (int k = 0; k < 100000; ++k) histogram.add(std::ldexp(1.0 + (k % 7) / 7.0, k % 10));
  const auto cut = size_cut<3>(histogram, {1023.0, 1.0, 0.0, 50.0});
  ASSERT_TRUE(cut.has_value());
  EXPECT_GT(*cut, 1.0);
  EXPECT_LE(*cut, 1023.0);
}

/// Coarse elements are as many as the square root of all, or the next smaller ones are none either.
TEST(CoarseCut, LeavesUpToTheRootOfAll) {
  const auto cut_with = [](int large, int larger) {
    const auto histogram =
        histogram_of({{1.0, 10000 - large - larger}, {8.0, large}, {64.0, larger}});
    const engine::SizeDistribution sizes{64.0, 1.0, 0.0, 100.0};
    return engine::plan_coarse<3>({histogram, sizes}, sizes, 1e300).cut.value_or(0.0);
  };
  EXPECT_EQ(cut_with(90, 10), 1.5);
  EXPECT_EQ(cut_with(91, 10), 12.0);
  EXPECT_EQ(cut_with(0, 100), 1.5);
  EXPECT_EQ(cut_with(0, 101), 0.0);
}

/// A giant among small ones costs little beside them, one that is hardly larger saves nothing.
TEST(CoarseCut, CostsWhatItSaves) {
  const auto gain = [](double large) {
    const auto histogram = histogram_of({{1.0, 10000}, {large, 1}});
    const engine::SizeDistribution sizes{large, 1.0, 0.0, 3e4 / std::pow(large, 3.0)};
    const engine::SizeClasses classes(histogram, sizes);
    return engine::plan_sizes<3>(classes, sizes).cost /
           engine::plan_coarse<3>(classes, sizes, 5.0).cost;
  };
  EXPECT_GT(gain(8.0), 1.5);
  EXPECT_EQ(gain(1.01), 0.0);
}

/// Others that crowd are not for layers.
TEST(CoarseCut, NoneWhereOthersCrowd) {
  const auto histogram = histogram_of({{1.0, 10000}, {8.0, 10}});
  // Of radius 1, which may be 1.5, 5 others share a cell.
  const double volume = 10000.0 * std::pow(1.5 / 8.0, 3.0) / 5.0;
  for (const double wider : {0.99, 1.01}) {
    const engine::SizeDistribution sizes{8.0, 1.0, 0.0, volume * wider};
    EXPECT_EQ(engine::plan_coarse<3>({histogram, sizes}, sizes, 5.0).cut.has_value(), wider > 1.0);
  }
}

}  // namespace
}  // namespace abut::testing
