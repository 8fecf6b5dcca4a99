// What becomes a search set of its own.

#include "engine/divide.hpp"

#include "engine/random_spheres.hpp"
#include "support/nobody_asked.hpp"

#include <abut/simd.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::testing {
namespace {

std::vector<std::uint32_t> sorted(std::span<const std::uint32_t> numbers) {
  std::vector<std::uint32_t> result(numbers.begin(), numbers.end());
  std::sort(result.begin(), result.end());
  return result;
}

template <class Dimension>
class CollectedTile : public ::testing::Test {};

TYPED_TEST_SUITE(CollectedTile, Dimensions);

/// In a periodic domain positions may be off by 2^-24 of a cell: coarse elements that seem to miss
/// the locals by no more are kept, others are left out.
TYPED_TEST(CollectedTile, KeepsCoarseElementsThatTouchButForTheirRounding) {
  constexpr int dim = TypeParam::value;
  constexpr double cell = 1.0;
  constexpr double radius = 0.25;
  Spheres<dim> spheres(1);
  for (double& x : spheres[0].center) x = 0.5;
  spheres[0].radius = radius;
  for (const double missing : {0.0, 0x1p-24, 0x1p-12}) {
    exact::Sphere<dim> coarse = spheres[0];
    coarse.radius = 8.0;
    coarse.center[0] += coarse.radius + radius + missing;
    spheres.push_back(coarse);
  }
  const std::vector<std::uint32_t> coarse_elements{1, 2, 3};
  engine::SearchSet<dim> set;
  set.bounds = bounds_of<dim>({spheres[0]});
  set.locals = engine::Numbers(1);
  set.coarse_elements = engine::Numbers(coarse_elements.data(), coarse_elements.size());
  const auto grid = engine::TileGrid<dim>::over(set.bounds, cell, 4.0, 1.0);
  base::MemoryMeter memory;
  engine::Tiles<dim> tiles(memory);
  const exact::Elements<dim> elements{spheres, {}};
  abut::testing::NobodyAsked nobody;
  tiles.partition(elements, set, grid, 0.0, kernels::element_kernels(Simd::scalar), 1, nobody.work);
  std::size_t tile = 0;
  while (tiles.own_count(tile) == 0) ++tile;
  // The locals' box is flat, and so is their tile.
  EXPECT_EQ(sorted(tiles.coarse_elements(tile)), (std::vector<std::uint32_t>{1, 2}));

  engine::Members members(memory);
  const engine::SearchSet<dim> collected =
      engine::collect_tile(elements, tiles, tile, cell, 0.0, kernels::element_kernels(Simd::scalar),
                           members, nobody.work);
  EXPECT_EQ(collected.coarse_elements.size(), 2U);
  EXPECT_EQ(sorted(members.coarse_elements), (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace abut::testing
