// How many candidate pairs `rows` tests: a bound on every scene, and what its ways of searching are
// for. Work is counted, not timed.

#include "scenes/many_scales.hpp"
#include "support/rows_without_plane.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <string>

namespace abut::testing {
namespace {

using scenes::Directions;
using scenes::Radii;

/// Candidate tests for each element and contact pair.
double tests_of(const scenes::Scene& scene) {
  const Statistics statistics =
      count_contact_pairs(view_of(scene), Domain::open(), {.algorithm = Algorithm::rows});
  return static_cast<double>(statistics.candidate_tests) /
         static_cast<double>(scene.size() + statistics.contact_pairs);
}

double tests_of(const scenes::SceneInfo& info, std::size_t count) {
  return tests_of(info.make(count, 1));
}

class RowsWork : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(RowsWork, IsBounded) {
  for (const std::size_t count : {100U, 3000U, 30000U}) {
    if (GetParam().name == "coincident" && count > 3000U) continue;  // (N^2 - N) / 2 pairs
    EXPECT_LE(tests_of(GetParam(), count), 150.0) << count << " elements";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, RowsWork,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

/// Crowds within crowds are cut out until they are none, whatever their shape and depth.
TEST(RowsWork, IsBoundedWhereDensitySpansDecades) {
  for (const Directions directions :
       {Directions::all, Directions::one_ray, Directions::near_three_axes}) {
    for (const Radii radii : {Radii::equal, Radii::as_root, Radii::as_distance}) {
      for (const double decades : {12.0, 60.0}) {
        for (const std::size_t count : {1000U, 20000U, 40000U}) {
          EXPECT_LE(tests_of(scenes::spheres_of_scales({directions, radii}, decades, count)), 300.0)
              << static_cast<int>(directions) << static_cast<int>(radii) << ": " << decades
              << " decades, " << count << " elements";
        }
      }
    }
  }
}

TEST(RowsWork, EqualSizesNeedTwentyTestsAtMost) {
  for (const char* const name :
       {"dense", "ordered", "gas", "sparse", "clusters", "hexagonal_2d", "touching_cubic"}) {
    EXPECT_LE(tests_of(scenes::scene_named(name), 30000), 20.0) << name;
  }
}

/// Where cells are far wider than the reach, a tile leaves out the rows that an element does not
/// lie near. Layers, which more elements are sorted into, look at all: that is faster.
TEST(RowsWork, NearlyEmptySpaceNeedsLessThanOneInATile) {
  const auto scene = scenes::scene_named("sparse").make(8000, 1);
  const auto run = rows_without_plane(view_of(scene), 0.0, Simd::scalar, 1);
  EXPECT_LT(static_cast<double>(run.candidate_tests), 8000.0);
}

/// A plane leaves the third axis undivided, and its vectors make eight tests at once.
TEST(RowsWork, FewElementsNeedSomeFiftyInAPlane) {
  EXPECT_LT(tests_of(scenes::scene_named("sparse"), 8000), 2.0);
  EXPECT_LT(tests_of(scenes::scene_named("gas"), 1000), 16.0);
  EXPECT_LT(tests_of(scenes::scene_named("dense"), 1000), 60.0);
}

}  // namespace
}  // namespace abut::testing
