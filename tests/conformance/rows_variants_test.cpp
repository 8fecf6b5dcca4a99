// Every scene through `rows` at every SIMD level that this processor has, with 1, 2, 3, 7 and 16
// threads, in float and double: the pairs of sorting_array, and always the same bytes.

#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

/// Several tiles in all of them; fewer elements where sorting_array takes its time.
std::size_t count_for(const scenes::SceneInfo& scene) {
  static const std::map<std::string_view, std::size_t> fewer{
      {"coincident", 400},   {"one_giant", 6000},        {"bidisperse", 12000},
      {"log_uniform", 6000}, {"log_uniform_1000", 6000}, {"graded", 6000},
      {"graded_1000", 6000}, {"two_far_clusters", 6000}};
  const auto found = fewer.find(scene.name);
  return found == fewer.end() ? 26000 : found->second;
}

PairVector pairs_of_sorting_array(const ElementView& elements, double margin) {
  const PairList list = find_contact_pairs(
      elements, Domain::open(), {.algorithm = Algorithm::sorting_array, .margin = margin});
  return {list.begin(), list.end()};
}

void check(const ElementView& elements, double margin) {
  SCOPED_TRACE("margin " + std::to_string(margin));
  EXPECT_TRUE(
      rows_agree(pairs_of_sorting_array(elements, margin), elements, margin, {1, 2, 3, 7, 16}));
}

class RowsVariants : public ::testing::TestWithParam<scenes::SceneInfo> {};

TEST_P(RowsVariants, Float64) {
  const scenes::Scene scene = GetParam().make(count_for(GetParam()), 3);
  check(view_of(scene), 0.0);
  check(view_of(scene), 0.3 * scene.radius[0]);
}

TEST_P(RowsVariants, Float32) {
  // So far apart, float32 leaves every element of a group in one place.
  const std::size_t count = GetParam().name == "two_far_clusters" ? 800 : count_for(GetParam());
  const Float32Scene scene(GetParam().make(count, 4));
  check(scene.view(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RowsVariants,
                         ::testing::ValuesIn(scenes::scenes().begin(), scenes::scenes().end()),
                         [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(SimdLevels, ThoseOfThisProcessorAreRun) {
  const std::string told = told_simd_levels();
  std::cout << told << '\n';
  RecordProperty("simd_levels", told);
  const std::vector<Simd> levels = simd_levels_here();
  ASSERT_FALSE(levels.empty());
  EXPECT_EQ(levels.front(), Simd::scalar);
}

}  // namespace
}  // namespace abut::testing
