// What becomes a group of its own.

#include "engine/divide.hpp"

#include "engine/random_spheres.hpp"
#include "support/nobody_asked.hpp"

#include <abut/simd.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::engine {
namespace {

std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> numbers) {
  std::vector<std::uint32_t> result(numbers.begin(), numbers.end());
  std::sort(result.begin(), result.end());
  return result;
}

template <class Dimension>
class CollectedTile : public ::testing::Test {};

TYPED_TEST_SUITE(CollectedTile, Dimensions);

/// In a periodic domain positions may be off by 2^-24 of a cell: visitors that seem to miss the
/// natives by no more are kept, others are left out.
TYPED_TEST(CollectedTile, KeepsVisitorsThatTouchButForTheirRounding) {
  constexpr int dim = TypeParam::value;
  constexpr double cell = 1.0;
  constexpr double radius = 0.25;
  Spheres<dim> spheres(1);
  for (double& x : spheres[0].center) x = 0.5;
  spheres[0].radius = radius;
  for (const double missing : {0.0, 0x1p-24, 0x1p-12}) {
    base::Sphere<dim> visitor = spheres[0];
    visitor.radius = 8.0;
    visitor.center[0] += visitor.radius + radius + missing;
    spheres.push_back(visitor);
  }
  const std::vector<std::uint32_t> visitors{1, 2, 3};
  Group<dim> group;
  group.bounds = bounds_of<dim>({spheres[0]});
  group.natives = Numbers(1);
  group.visitors = Numbers(visitors.data(), visitors.size());
  const auto grid = TileGrid<dim>::over(group.bounds, cell, 4.0, 1.0);
  base::MemoryMeter memory;
  Tiles<dim> tiles(memory);
  const base::Elements<dim> elements{spheres, {}};
  abut::testing::NobodyAsked nobody;
  tiles.partition(elements, group, grid, 0.0, kernels::element_kernels(Simd::scalar), 1,
                  nobody.work);
  std::size_t tile = 0;
  while (tiles.own_count(tile) == 0) ++tile;
  // The natives' box is flat, and so is their tile.
  EXPECT_EQ(sorted(tiles.visitors(tile)), (std::vector<std::uint32_t>{1, 2}));

  Members members(memory);
  const Group<dim> collected =
      collect_tile(elements, tiles, tile, cell, 0.0, kernels::element_kernels(Simd::scalar),
                   members, nobody.work);
  EXPECT_EQ(collected.visitors.size(), 2U);
  EXPECT_EQ(sorted(members.visitors), (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace abut::engine
