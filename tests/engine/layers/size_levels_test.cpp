// Levels of sizes: who belongs to which, who visits which, and the pairs of all.

#include "engine/layers/size_levels.hpp"

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class SizeLevelsOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  /// Elements whose radii grow with the distance from a point, from 1 to so much, with some pairs
  /// each.
  Spheres<its_dim> graded(std::size_t count, double largest) {
    Spheres<its_dim> spheres;
    const double part =
        std::pow(1.5 / static_cast<double>(count) * std::log(largest), 1.0 / its_dim);
    while (spheres.size() < count) {
      const double radius = std::pow(largest, random_.uniform(0.0, 1.0));
      std::array<double, 3> center{};
      double square = 0.0;
      for (std::size_t axis = 0; axis < its_dim; ++axis) {
        center[axis] = random_.uniform(-1.0, 1.0);
        square += center[axis] * center[axis];
      }
      if (square > 1.0 || square < 0.04) continue;
      for (double& x : center) x *= radius / (part * std::sqrt(square));
      spheres.push_back(sphere_at<its_dim>(center, radius));
    }
    return spheres;
  }

  static Boxes<its_dim> boxes_in(const Spheres<its_dim>& spheres) {
    Boxes<its_dim> boxes;
    for (const auto& sphere : spheres) {
      std::array<double, 3> lower{};
      std::copy_n(sphere.center, its_dim, lower.begin());
      boxes.push_back(
          box_at<its_dim>(lower, {2.0 * sphere.radius, sphere.radius, 0.25 * sphere.radius}));
    }
    return boxes;
  }

  static void expect_right_in_levels(const Spheres<its_dim>& spheres, std::size_t levels,
                                     double margin = 0.0) {
    expect_right_in_layers<its_dim>(spheres, margin, Way::layers, always_in_levels);
    const engine::RowsSettings settings{margin, 1, Simd::scalar, always_in_levels};
    EXPECT_EQ(run_rows<its_dim>(spheres, settings).levels, levels);
  }

  static engine::LayerSpheres<its_dim> in_layers(const Spheres<its_dim>& spheres) {
    return engine::LayerSpheres<its_dim>(
        kernels::SphereParts(kernels::strided_spheres(std::span(spheres))));
  }

  engine::SizeLevels<its_dim>& levels_of(const Spheres<its_dim>& spheres, double margin,
                                         std::size_t workers = 1) {
    base::WorkCounter work(context_.progress, 0);
    levels_.sort(in_layers(spheres), bounds_of<its_dim>(spheres), margin, 0.0, workers, work);
    return levels_;
  }

  /// Members and visitors of all levels, and the largest of these.
  static std::vector<double> all_of(const engine::SizeLevels<its_dim>& levels) {
    std::vector<double> all;
    for (std::size_t level = 0; level < engine::SizeLevels<its_dim>::most; ++level) {
      all.push_back(levels.largest_visitor(level));
      all.push_back(levels.bounds(level).largest_radius);
      for (const auto& numbers : {levels.members(level), levels.visitors(level)}) {
        all.push_back(static_cast<double>(numbers.size()));
        all.insert(all.end(), numbers.begin(), numbers.end());
      }
    }
    return all;
  }

  Random random_{static_cast<std::uint64_t>(191 + its_dim)};

 private:
  base::DetectionContext context_;
  engine::SizeLevels<its_dim> levels_{context_.memory};
};

TYPED_TEST_SUITE(SizeLevelsOf, Dimensions);

TYPED_TEST(SizeLevelsOf, EachElementIsAMemberOfOneLevel) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->graded(3000, 1e4);
  const auto bounds = bounds_of<dim>(spheres);
  const auto& levels = this->levels_of(spheres, 0.5);
  std::vector<std::uint32_t> all;
  for (std::size_t level = 0; level < engine::SizeLevels<dim>::most; ++level) {
    const auto members = levels.members(level);
    EXPECT_TRUE(std::ranges::is_sorted(members));
    all.insert(all.end(), members.begin(), members.end());
    for (const std::uint32_t member : members) {
      const double part =
          (2.0 * spheres[member].radius + 0.5) / (2.0 * bounds.largest_radius + 0.5);
      EXPECT_LE(part, std::ldexp(1.00001, -static_cast<int>(level)));
      EXPECT_GT(part, std::ldexp(0.5, -static_cast<int>(level)));
      EXPECT_LE(spheres[member].radius, levels.bounds(level).largest_radius);
    }
  }
  std::ranges::sort(all);
  ASSERT_EQ(all.size(), spheres.size());
  EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
}

/// Levels are sorted by fewer workers after more, and by more workers than elements.
TYPED_TEST(SizeLevelsOf, AreTheSameForAllWorkers) {
  for (const std::size_t count : {5U, 3000U}) {
    const auto spheres = this->graded(count, 1e3);
    const auto first = this->all_of(this->levels_of(spheres, 0.5));
    for (const std::size_t workers : {7U, 2U, 3U}) {
      EXPECT_EQ(this->all_of(this->levels_of(spheres, 0.5, workers)), first) << workers;
    }
  }
}

TYPED_TEST(SizeLevelsOf, LargerElementsWithinReachAreVisitors) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->graded(3000, 1e3);
  auto& levels = this->levels_of(spheres, 0.0);
  std::vector<std::size_t> level_of(spheres.size());
  std::size_t visitors = 0;
  for (std::size_t level = 0; level < engine::SizeLevels<dim>::most; ++level) {
    for (const std::uint32_t member : levels.members(level)) level_of[member] = level;
    for (const std::uint32_t one : levels.visitors(level)) EXPECT_LT(level_of[one], level);
    visitors += levels.visitors(level).size();
  }
  for (const ContactPair& pair : directly_checked<dim>(spheres, 0.0)) {
    const auto [larger, smaller] = level_of[pair.first] <= level_of[pair.second]
                                       ? std::pair(pair.first, pair.second)
                                       : std::pair(pair.second, pair.first);
    if (level_of[larger] == level_of[smaller]) continue;
    EXPECT_TRUE(std::ranges::binary_search(levels.visitors(level_of[smaller]), larger));
  }
  EXPECT_LT(visitors, spheres.size());
  const auto estimate = levels.estimate(this->in_layers(spheres), bounds_of<dim>(spheres), 0.0);
  EXPECT_LE(estimate.levels, 10U);
  EXPECT_GE(estimate.levels, 8U);
  const double counted = static_cast<double>(visitors) / static_cast<double>(spheres.size());
  EXPECT_NEAR(estimate.visitors, counted, 0.2);
}

TYPED_TEST(SizeLevelsOf, AllPairsOfGradedElements) {
  this->expect_right_in_levels(this->graded(1500, 20.0), 5);
  this->expect_right_in_levels(this->graded(1500, 20.0), 4, 1.0);
  this->expect_right_in_levels(this->graded(1500, 1e6), 20);
}

/// Some in one place, some inside of larger ones, and one alone in its level.
TYPED_TEST(SizeLevelsOf, CrowdsAndLonelyElements) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->graded(900, 30.0);
  append<dim>(spheres, Spheres<dim>(300, sphere_at<dim>({3.0, 4.0, 5.0}, 1.5)));
  append<dim>(spheres, uniform_spheres<dim>(this->random_, 100, {300.0, 300.0, 300.0}, 0.5));
  append<dim>(spheres, Spheres<dim>(1, sphere_at<dim>({3.0, 4.0, 5.0}, 0.01)));
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_levels);
}

/// More octaves than levels: the last one has the rest, radii of 0 among them.
TYPED_TEST(SizeLevelsOf, RadiiOfAllMagnitudes) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  for (const double factor : {1.0, 0x1p-30, 0x1p-60, 0.0}) {
    auto some = uniform_spheres<dim>(this->random_, 200, box_for<dim>(200, 4.0));
    for (auto& sphere : some) {
      for (double& x : sphere.center) x *= factor;
      sphere.radius *= factor * this->random_.uniform(0.5, 1.0);
    }
    append<dim>(spheres, some);
  }
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_levels);
}

/// A reach of 2^-1060 has no inverse, and may be searched in any way.
TYPED_TEST(SizeLevelsOf, NumbersOfAllScales) {
  constexpr int dim = TypeParam::value;
  for (const double scale : {0x1p-1060, 0x1p-900, 0x1p900}) {
    auto spheres = this->graded(600, 40.0);
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x *= scale;
      sphere.radius *= scale;
    }
    const engine::RowsSettings settings{0.0, 1, Simd::scalar, always_in_levels};
    EXPECT_TRUE(
        same_pairs(directly_checked<dim>(spheres, 0.0), run_rows<dim>(spheres, settings).pairs));
  }
}

/// Single precision does not hold the squares of visitors that are 2^38 reaches of a level large:
/// these are searched otherwise.
TYPED_TEST(SizeLevelsOf, VisitorsBeyondAllUnits) {
  constexpr int dim = TypeParam::value;
  for (const double tiny : {0x1p-30, 0x1p-40, 0x1p-80, 0x1p-300}) {
    Spheres<dim> spheres;
    for (const double factor : {1.0, tiny}) {
      auto some = uniform_spheres<dim>(this->random_, 200, box_for<dim>(200, 4.0));
      for (auto& sphere : some) {
        for (double& x : sphere.center) x = (x + (factor < 1.0 ? 0.0 : 0.3)) * factor;
        sphere.radius *= factor;
      }
      append<dim>(spheres, some);
    }
    append<dim>(spheres, {sphere_at<dim>({0.2, 0.2, 0.2})});
    const engine::RowsSettings settings{0.0, 1, Simd::scalar, always_in_levels};
    const LayerRun run = run_rows<dim>(spheres, settings);
    EXPECT_TRUE(same_pairs(directly_checked<dim>(spheres, 0.0), run.pairs)) << run.levels;
    EXPECT_EQ(run.levels, tiny < 0x1p-33 ? 0U : 2U) << tiny;
  }
}

/// Mixed everywhere: each larger element visits the levels of all smaller ones.
TYPED_TEST(SizeLevelsOf, SizesThatDoNotFollowThePlace) {
  constexpr int dim = TypeParam::value;
  auto spheres = uniform_spheres<dim>(this->random_, 1500, box_for<dim>(1500, 2.0));
  for (auto& sphere : spheres) sphere.radius = std::pow(0.01, this->random_.uniform(0.0, 1.0));
  this->expect_right_in_levels(spheres, 7);
  append<dim>(spheres, uniform_spheres<dim>(this->random_, 1, {5.0, 5.0, 5.0}, 40.0));
  append<dim>(spheres,
              {sphere_at<dim>({1e9, -1e9, 1e9}, 3.0), sphere_at<dim>({1e9, 0.0, 0.0}, 1e9)});
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_levels);
}

TYPED_TEST(SizeLevelsOf, PairsOfBoxes) {
  constexpr int dim = TypeParam::value;
  for (const double margin : {0.0, 0.5}) {
    expect_right_in_layers<dim>(this->boxes_in(this->graded(1200, 50.0)), margin, Way::layers,
                                always_in_levels);
  }
}

/// Neighbors of other levels that touch, or fail to by a last place.
TYPED_TEST(SizeLevelsOf, PairsAtTheReach) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  double x = 0.0;
  for (int k = 0; k < 600; ++k) {
    const double radius = std::ldexp(1.0, k % 7);
    x = beside(this->random_, x + radius);
    spheres.push_back(sphere_at<dim>({x, 0.25, 0.75}, radius));
    x += radius;
  }
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_levels);
}

/// Spheres in a unit cube whose radii grow from the middle to the corners, as many times as asked
/// for, and which are the rarer the larger they are. They fill two fifths of it.
Spheres<3> refined_in_the_middle(Random& random, std::size_t count, double ratio) {
  Spheres<3> spheres;
  double volume = 0.0;
  while (spheres.size() < count) {
    std::array<double, 3> center{};
    double square = 0.0;
    for (double& x : center) {
      x = random.uniform(-0.5, 0.5);
      square += x * x;
    }
    const double radius = 1.0 + (ratio - 1.0) * std::min(1.0, 1.15 * std::sqrt(square));
    const double cube = radius * radius * radius;
    if (random.uniform(0.0, 1.0) * cube > 1.0) continue;
    volume += 4.19 * cube;
    spheres.push_back(sphere_at<3>(center, radius));
  }
  for (auto& sphere : spheres) sphere.radius *= std::cbrt(0.4 / volume);
  return spheres;
}

/// Blocks of candidates hold crowds of all sizes; in levels of sizes they crowd less.
TEST(SizeLevels, AreTakenWhereMixturesCrowd) {
  Random random(195);
  engine::LayerLimits limits;
  limits.least_elements_of_levels = limits.least_elements_of_copies = 5000;
  limits.least_elements_beside_coarse = std::size_t{1} << 40;
  for (const double ratio : {4.0, 16.0}) {
    const auto spheres = refined_in_the_middle(random, 20000, ratio);
    limits.most_joined_without_levels = engine::LayerLimits{}.most_joined_without_levels;
    const LayerRun chosen = run_rows<3>(spheres, {0.0, 1, Simd::scalar, limits});
    EXPECT_EQ(chosen.levels > 0, ratio > 8.0) << ratio;
    limits.most_joined_without_levels = std::numeric_limits<double>::infinity();
    const LayerRun crowds = run_rows<3>(spheres, {0.0, 1, Simd::scalar, limits});
    EXPECT_TRUE(crowds.in_layers);
    EXPECT_EQ(crowds.levels, 0U);
    EXPECT_GE(crowds.candidate_tests, (ratio > 8.0 ? 8 : 1) * chosen.candidate_tests);
    EXPECT_TRUE(same_pairs(directly_checked<3>(spheres, 0.0), chosen.pairs));
  }
}

/// In tiles each took more than a hundred.
TYPED_TEST(SizeLevelsOf, GradedElementsTakeFewTests) {
  constexpr int dim = TypeParam::value;
  constexpr std::size_t count = 20000;
  const auto spheres = this->graded(count, 1e3);
  const LayerRun run = run_rows<dim>(spheres, {0.0, 1, Simd::scalar, {}});
  EXPECT_GT(run.levels, 0U);
  EXPECT_TRUE(same_pairs(directly_checked<dim>(spheres, 0.0), run.pairs));
  EXPECT_LE(run.candidate_tests, 30 * count);
}

}  // namespace
}  // namespace abut::testing
