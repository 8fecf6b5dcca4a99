// Levels of sizes in domains so wide that gaps are closed: larger elements look for partners beyond
// the gaps, in cells that they find by the lowest element of each stretch.

#include "device/host/as_rows.hpp"
#include "scenes/box_scene.hpp"
#include "scenes/random.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/domain.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

constexpr double side = 1e14;

/// Small elements strewn widely, some beside each other, and a few giants: small ones lie in them,
/// at their surfaces and beyond.
Scene strewn_with_giants(int dimensions, std::size_t count, std::size_t giants,
                         std::uint64_t seed) {
  Scene scene;
  scene.dimensions = dimensions;
  Random random(seed);
  const auto add = [&](double x, double y, double z, double radius) {
    scene.x.push_back(x);
    scene.y.push_back(y);
    if (dimensions == 3) scene.z.push_back(z);
    scene.radius.push_back(radius);
  };
  for (std::size_t k = 0; k < count; ++k) {
    const double x = random.uniform(-side, side);
    const double y = random.uniform(-side, side);
    const double z = random.uniform(-side, side);
    add(x, y, z, random.uniform(0.1, 1.0));
    if (k % 4 == 0) add(x + random.uniform(-2.0, 2.0), y + 1.0, z, random.uniform(0.1, 1.0));
    if (k < giants) add(x + 2e13, y, z, 2e13 + random.uniform(-2.0, 2.0));
  }
  return scene;
}

class DeviceWideLevels : public ::testing::TestWithParam<int> {};

TEST_P(DeviceWideLevels, OfSpheresAndBoxes) {
  const int dimensions = GetParam();
  for (const std::size_t giants : {std::size_t{1}, std::size_t{5}}) {
    const Scene scene = strewn_with_giants(dimensions, 1500, giants, 3 + giants);
    const scenes::BoxScene boxes = scenes::boxes_in(scene, 4);
    EXPECT_GT(expect_as_rows(view_of(scene), Domain::open()), 30U);
    EXPECT_GT(expect_as_rows(view_of(boxes), Domain::open()), 30U);
  }
}

/// Along open axes, beside a periodic face.
TEST_P(DeviceWideLevels, BesideAPeriodicFace) {
  const int dimensions = GetParam();
  const Scene scene = strewn_with_giants(dimensions, 600, 3, 11);
  const scenes::BoxScene boxes = scenes::boxes_in(scene, 4);
  const Domain domain = dimensions == 2 ? Domain::periodic({2.0 * side, unbounded})
                                        : Domain::periodic({2.0 * side, unbounded, unbounded});
  EXPECT_GT(expect_as_rows(view_of(scene), domain), 5U);
  EXPECT_GT(expect_as_rows(view_of(boxes), domain), 5U);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, DeviceWideLevels, ::testing::Values(2, 3));

}  // namespace
}  // namespace abut::testing
