// Random systems made to send `rows` through its divisions (support/crowded_systems.hpp), against
// the oracle: crowded tiles and divisions by size within each other, with copies from the tiles
// around. A failure names seed and dimensions.

#include "support/crowded_systems.hpp"
#include "support/rows_variants.hpp"
#include "support/scene_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

constexpr std::size_t count = 3000;
constexpr std::uint64_t seeds_per_block = 10;

/// Far from 1: also as large as numbers can be, where the engine works at a smaller scale.
int exponent_for(std::uint64_t seed, const scenes::Scene& scene) {
  if (seed % 8 == 1) return -900;
  if (seed % 8 != 0) return 0;
  double largest = 0.0;
  for (const auto* numbers : {&scene.x, &scene.y, &scene.z, &scene.radius}) {
    for (const double number : *numbers) largest = std::max(largest, std::fabs(number));
  }
  return 1022 - std::ilogb(largest);
}

class RowsCrowds : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  static void check(int dimensions, std::uint64_t seed) {
    SCOPED_TRACE(std::to_string(dimensions) + "D, seed " + std::to_string(seed));
    const CrowdedSystem system = crowded_system(dimensions, count, seed);
    if (seed % 4 == 2) {
      const Float32Scene rounded(system.scene);
      const PairVector expected = oracle_pairs(rounded.widened, system.margin);
      EXPECT_TRUE(rows_agree(expected, rounded.view(), system.margin, {1, 3}));
      return;
    }
    const PairVector expected = oracle_pairs(system.scene, system.margin);
    const CrowdedSystem searched = scaled(system, exponent_for(seed, system.scene));
    EXPECT_TRUE(rows_agree(expected, view_of(searched.scene), searched.margin, {1, 3}));
  }
};

TEST_P(RowsCrowds, In2D) {
  for (std::uint64_t k = 0; k < seeds_per_block; ++k) check(2, GetParam() * seeds_per_block + k);
}
TEST_P(RowsCrowds, In3D) {
  for (std::uint64_t k = 0; k < seeds_per_block; ++k) check(3, GetParam() * seeds_per_block + k);
}

INSTANTIATE_TEST_SUITE_P(Blocks, RowsCrowds, ::testing::Range<std::uint64_t>(0, 10));

}  // namespace
}  // namespace abut::testing
