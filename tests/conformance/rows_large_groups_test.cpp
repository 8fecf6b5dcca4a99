// Groups inside a tile that are large enough to wait for all workers, also within each other, and
// visitors so large or so far away that single precision says nothing about them.

#include "scenes/many_scales.hpp"
#include "scenes/random.hpp"
#include "support/box_oracle.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace abut::testing {
namespace {

using scenes::Directions;
using scenes::Radii;
using scenes::Random;
using scenes::Scene;

PairVector pairs_of_sorting_array(const Scene& scene) {
  const PairList list = find_contact_pairs(view_of(scene), Domain::open(),
                                           {.algorithm = Algorithm::sorting_array, .threads = 1});
  return {list.begin(), list.end()};
}

void add(Scene& scene, double x, double y, double z, double radius) {
  scene.x.push_back(x);
  scene.y.push_back(y);
  if (scene.dimensions == 3) scene.z.push_back(z);
  scene.radius.push_back(radius);
}

/// An even cloud, about a pair an element; one element in sixteen is four times as large.
void add_cloud(Scene& scene, Random& random, std::size_t count, double x, double spacing) {
  const auto side = scene.dimensions == 2 ? std::sqrt(static_cast<double>(count))
                                          : std::ceil(static_cast<double>(count) / 1600.0);
  const double wide = scene.dimensions == 2 ? side : 40.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double radius = spacing * (random.below(16) == 0 ? 1.2 : 0.3);
    add(scene, x + spacing * random.uniform(0.0, side), spacing * random.uniform(0.0, wide),
        spacing * random.uniform(0.0, 40.0), radius);
  }
}

TEST(RowsLargeGroups, TwoFarClustersOfFortyThousand) {
  const Scene scene = scenes::scene_named("two_far_clusters").make(80000, 1);
  const PairVector expected = pairs_of_sorting_array(scene);
  ASSERT_GT(expected.size(), 1000U);
  EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 2, 3}));
}

/// Crowds that become sets of their own, the outer ones of which wait for all workers.
TEST(RowsLargeGroups, CrowdsWithinCrowds) {
  Scene scene = scenes::scene_named("crowds").make(90000, 1);
  for (std::size_t k = 0; k < scene.size(); ++k) {  // eight decades instead of four
    const double distance = std::hypot(scene.x[k], scene.y[k], scene.z[k]);
    for (auto* numbers : {&scene.x, &scene.y, &scene.z}) (*numbers)[k] *= 0.1 * distance;
  }
  for (const double margin : {0.0, 1.5}) {
    const PairVector expected = [&] {
      const PairList list =
          find_contact_pairs(view_of(scene), Domain::open(),
                             {.algorithm = Algorithm::sorting_array, .margin = margin});
      return PairVector(list.begin(), list.end());
    }();
    ASSERT_GT(expected.size(), 1000U);
    EXPECT_TRUE(rows_agree(expected, view_of(scene), margin, {1, 2, 3}));
  }
}

/// Pairs of spheres whose density spans decades by an algorithm without cells.
void expect_right_at_all_scales(const scenes::ManyScales& what, double decades, std::size_t count) {
  SCOPED_TRACE(std::to_string(static_cast<int>(what.directions)) +
               std::to_string(static_cast<int>(what.radii)) + ", decades " +
               std::to_string(decades));
  const Scene scene = scenes::spheres_of_scales(what, decades, count);
  const PairList expected =
      find_contact_pairs(view_of(scene), Domain::open(), {.algorithm = Algorithm::direct_check});
  EXPECT_TRUE(rows_agree(expected.pairs(), view_of(scene), 0.0, {1, 2, 3}));
}

/// Sets within sets, which wait for those that they came of: a hundred depths, by any worker.
TEST(RowsLargeGroups, AtAllScales) {
  for (const Directions directions :
       {Directions::all, Directions::one_ray, Directions::near_three_axes}) {
    for (const Radii radii : {Radii::equal, Radii::as_root, Radii::as_distance}) {
      for (const double decades : {5.0, 60.0, 250.0}) {
        expect_right_at_all_scales({directions, radii, 30.0}, decades, 2000);
      }
    }
  }
}

/// Two pairs of clouds: each pair is crowded where it lies, and each cloud of a pair again.
TEST(RowsLargeGroups, WithinLargeGroups) {
  for (const int dimensions : {2, 3}) {
    Scene scene;
    scene.dimensions = dimensions;
    Random random(5);
    for (const double x : {0.0, 1e7, 1e15, 1e15 + 1e7}) add_cloud(scene, random, 35000, x, 8.0);
    const PairVector expected = pairs_of_sorting_array(scene);
    ASSERT_GT(expected.size(), 10000U);
    EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 3}));
  }
}

/// A cloud whose radii ask for a division in a tile of more than 32768 elements.
TEST(RowsLargeGroups, DividedBySize) {
  Scene scene;
  Random random(6);
  add_cloud(scene, random, 36000, 0.0, 1.0);
  for (int k = 0; k < 40; ++k) {
    add(scene, random.uniform(0.0, 23.0), random.uniform(0.0, 40.0), random.uniform(0.0, 40.0), 9);
  }
  add(scene, 3e6, 0.0, 0.0, 9.0);
  const PairVector expected = pairs_of_sorting_array(scene);
  EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 3}));
}

/// Full cells, too few for two tiles: the only one is searched by all workers, layer by layer. The
/// giant visits it afterwards.
TEST(RowsLargeGroups, OneTileForAll) {
  for (const int dimensions : {2, 3}) {
    Scene scene;
    scene.dimensions = dimensions;
    Random random(8);
    const double side = dimensions == 2 ? 68.0 : 24.0;
    for (int k = 0; k < 12000; ++k) {
      add(scene, random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(0.0, side),
          random.uniform(0.2, 1.0));
    }
    add(scene, -40.0, 0.5 * side, 0.5 * side, 40.0 + 0.2 * side);
    EXPECT_TRUE(rows_agree(pairs_of_sorting_array(scene), view_of(scene), 0.0, {1, 2, 3, 7, 16}));
    const scenes::BoxScene boxes = scenes::boxes_in(scene, 9);
    const PairList list =
        find_contact_pairs(view_of(boxes), Domain::open(), {.algorithm = Algorithm::direct_check});
    EXPECT_TRUE(rows_agree(list.pairs(), view_of(boxes), 0.0, {1, 3}));
  }
}

/// Small elements on a lattice of halves in a box, and giants whose surfaces pass through it: on an
/// axis through a giant's center touching is exact.
Scene small_ones_and_giants(int dimensions, double giant) {
  Scene scene;
  scene.dimensions = dimensions;
  Random random(7);
  const auto half = [&] { return 0.5 * std::floor(random.uniform(0.0, 120.0)); };
  for (int k = 0; k < 6000; ++k) add(scene, half(), half(), half(), 0.5);
  add(scene, -giant, 30.0, 30.0, giant + 20.0);
  add(scene, giant + 40.0, 30.0, 30.0, giant);
  add(scene, 30.0, -giant, 30.0, giant + 10.5);
  add(scene, giant, giant, dimensions == 3 ? giant : 0.0, giant);
  return scene;
}

TEST(RowsVisitors, TooLargeForSinglePrecision) {
  for (const int dimensions : {2, 3}) {
    for (const double giant : {0x1p8, 0x1p12, 0x1p20, 0x1p33, 0x1p45, 0x1p60, 0x1p300}) {
      SCOPED_TRACE(std::to_string(dimensions) + "D, radius " + std::to_string(giant));
      const Scene scene = small_ones_and_giants(dimensions, giant);
      const PairVector expected = oracle_pairs(scene);
      const auto count = count_contact_pairs(view_of(scene), Domain::open(),
                                             {.algorithm = Algorithm::rows, .threads = 1});
      EXPECT_LT(count.candidate_tests, 200 * (scene.size() + expected.size()));
      EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 3}));
    }
  }
}

}  // namespace
}  // namespace abut::testing
