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
  const auto& kernels = kernels::element_kernels(Simd::scalar);
  EXPECT_EQ(tiles.count(elements, set, grid, kernels, 1, nobody.work), 1U);
  tiles.sort(elements, set, grid, 0.0, kernels, 1, nobody.work);
  std::size_t tile = 0;
  while (tiles.own_count(tile) == 0) ++tile;
  // The locals' box is flat, and so is their tile.
  EXPECT_EQ(sorted(tiles.coarse_elements(tile)), (std::vector<std::uint32_t>{1, 2}));

  engine::Members members(memory);
  members.make_room({tiles.own_count(tile), tiles.records(tile).size(), 2});
  const engine::SearchSet<dim> collected =
      engine::collect_tile(elements, tiles, tile, cell, 0.0, kernels, members, nobody.work);
  EXPECT_EQ(collected.coarse_elements.size(), 2U);
  EXPECT_EQ(sorted(members.coarse_elements), (std::vector<std::uint32_t>{1, 2}));
}

/// After a division by size coarse elements are those within reach of the set, in whose box they
/// need not lie: small ones here touch large ones but for the margin, or miss them.
TYPED_TEST(CollectedTile, LargeElementsReachSetsOfSmallOnes) {
  constexpr int dim = TypeParam::value;
  constexpr double margin = 0.5;
  constexpr double radius = 0.25;
  Spheres<dim> spheres(1);
  spheres[0].radius = radius;
  for (const double missing : {0.0, 0x1p-12}) {
    for (const double side : {-1.0, 1.0}) {
      exact::Sphere<dim> large = spheres[0];
      large.radius = 8.0;
      large.center[dim - 1] += side * (large.radius + radius + margin + missing);
      spheres.push_back(large);
    }
  }
  const exact::Elements<dim> elements{spheres, {}};
  engine::SearchSet<dim> set;
  set.locals = engine::Numbers(spheres.size());
  NobodyAsked nobody;
  const engine::SizeCounts counts = engine::count_by_size(elements, set, 1.0, nobody.work);
  EXPECT_EQ(counts.small.locals, 1U);
  EXPECT_EQ(counts.small.coarse_elements, 4U);
  EXPECT_EQ(counts.large.locals, 4U);
  base::MemoryMeter memory;
  engine::Members large(memory);
  engine::Members small(memory);
  engine::Members across(memory);
  large.make_room(counts.large);
  small.make_room(counts.small);
  across.make_room(counts.across);
  engine::divide_by_size(elements, set, 1.0, {large, small, across}, nobody.work);
  EXPECT_EQ(sorted(large.locals), (std::vector<std::uint32_t>{1, 2, 3, 4}));
  const auto of_small = engine::search_set_of(elements, small, set.wanted, margin + 0x1p-20,
                                              kernels::element_kernels(Simd::scalar), nobody.work);
  ASSERT_EQ(of_small.locals.size(), 1U);
  EXPECT_EQ(of_small.locals[0], 0U);
  EXPECT_EQ(of_small.coarse_elements.size(), 2U);
  EXPECT_EQ(sorted(small.coarse_elements), (std::vector<std::uint32_t>{1, 2}));
}

}  // namespace
}  // namespace abut::testing
