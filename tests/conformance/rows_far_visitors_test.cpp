// Elements so much larger than the others that `rows` cannot meet these in single precision: they
// reach into the tiles from more than a thousand tiles away.

#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace abut::testing {
namespace {

struct Giants {
  std::string_view crowd;  ///< the scene of the small ones
  double radius;           ///< theirs, the small ones being of radius 1 or so
};

void append(scenes::Scene& scene, double x, double y, double z, double radius) {
  scene.x.push_back(x);
  scene.y.push_back(y);
  if (scene.dimensions == 3) scene.z.push_back(z);
  scene.radius.push_back(radius);
}

/// Three of them, numbered first, between and last, whose surfaces cut through the small ones.
scenes::Scene with_giants(const Giants& giants) {
  const scenes::Scene crowd = scenes::scene_named(giants.crowd).make(1200, 5);
  const auto [least, most] = std::minmax_element(crowd.x.begin(), crowd.x.end());
  const double middle = 0.5 * (*least + *most);
  scenes::Scene scene;
  scene.dimensions = crowd.dimensions;
  for (std::size_t k = 0; k < crowd.size(); ++k) {
    const double z = crowd.dimensions == 3 ? crowd.z[k] : 0.0;
    if (k == 0) append(scene, middle - giants.radius, middle, middle, giants.radius);
    if (k == 600) append(scene, middle, middle + giants.radius, middle, giants.radius);
    append(scene, crowd.x[k], crowd.y[k], z, crowd.radius[k]);
  }
  append(scene, middle + giants.radius, middle, middle, giants.radius);
  return scene;
}

class RowsFarVisitors : public ::testing::TestWithParam<Giants> {};

TEST_P(RowsFarVisitors, AreFoundWithTheLowerNumberFirst) {
  const scenes::Scene scene = with_giants(GetParam());
  const PairVector expected = oracle_pairs(scene);
  const auto of_giant = [&](ElementIndex giant) {
    return std::count_if(expected.begin(), expected.end(), [giant](ContactPair pair) {
      return pair.first == giant || pair.second == giant;
    });
  };
  for (const ElementIndex giant : {0U, 601U, 1202U}) EXPECT_GT(of_giant(giant), 300) << giant;
  EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 3}));
}

INSTANTIATE_TEST_SUITE_P(Crowds, RowsFarVisitors,
                         ::testing::Values(Giants{"gas_2d", 1e6}, Giants{"gas", 1e5},
                                           Giants{"gas", 1e9}, Giants{"dense", 1e6}),
                         [](const auto& parameter) {
                           return std::string(parameter.param.crowd) + "_" +
                                  std::to_string(parameter.index);
                         });

}  // namespace
}  // namespace abut::testing
