// Tiles that `rows` divides by size, beside others: large and small elements on both sides of the
// faces between them, in open space.

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace abut::testing {
namespace {

using scenes::Random;
using scenes::Scene;

constexpr double side = 100.0;
constexpr double large = 1.0;
constexpr double small = 0.15;

void add(Scene& scene, const std::array<double, 3>& center, double radius) {
  scene.x.push_back(center[0]);
  scene.y.push_back(center[1]);
  if (scene.dimensions == 3) scene.z.push_back(center[2]);
  scene.radius.push_back(radius);
}

/// Large elements everywhere, so sparse that the whole is not divided; and along each axis a thread
/// of small and large ones, crowded enough that the tiles on its way are.
Scene threads_through_all_tiles(int dimensions) {
  Scene scene;
  scene.dimensions = dimensions;
  Random random(21);
  for (int k = 0; k < 1000; ++k) {
    add(scene, {random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(0.0, side)},
        large);
  }
  for (std::size_t along = 0; along < static_cast<std::size_t>(dimensions); ++along) {
    for (int k = 0; k < 3000; ++k) {
      std::array<double, 3> center{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        center[axis] = random.uniform(0.0, axis == along ? side : 1.5) + (axis == along ? 0 : 30);
      }
      add(scene, center, k % 20 == 0 ? large : small);
    }
  }
  return scene;
}

TEST(RowsDividedTiles, MeetAcrossTheirFaces) {
  for (const int dimensions : {2, 3}) {
    const Scene scene = threads_through_all_tiles(dimensions);
    const PairVector expected = oracle_pairs(scene);
    ASSERT_GT(expected.size(), 5000U);
    EXPECT_TRUE(rows_agree(expected, view_of(scene), 0.0, {1, 3}));
  }
}

}  // namespace
}  // namespace abut::testing
