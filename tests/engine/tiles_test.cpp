#include "engine/tiles.hpp"

#include "engine/random_spheres.hpp"
#include "engine/tile_neighbors.hpp"
#include "support/nobody_asked.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <span>
#include <vector>

namespace abut::engine {
namespace {

template <class Dimension>
class TilesOf : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;
  static constexpr std::size_t natives = 6000;
  static constexpr std::size_t foreigns = 500;
  static constexpr std::size_t visitors = 60;

  /// Natives in the box, foreigns less than a cell outside it, visitors of any size anywhere.
  TilesOf() {
    Random random(6);
    const std::array<double, 3> extent{60, 50, 40};
    spheres = random_spheres<dim>(random, natives, extent);
    group.bounds = bounds_of<dim>(spheres);
    group.bounds.largest_radius = 0.5;
    for (std::size_t k = 0; k < foreigns; ++k) {
      auto sphere = random_spheres<dim>(random, 1, extent)[0];
      const std::size_t axis = random.below(dim);
      const double beyond = random.uniform(1e-9, cell);
      sphere.center[axis] = random.below(2) == 0 ? group.bounds.lower[axis] - beyond
                                                 : group.bounds.upper[axis] + beyond;
      spheres.push_back(sphere);
    }
    for (std::size_t k = 0; k < visitors; ++k) {
      auto sphere = random_spheres<dim>(random, 1, {100, 100, 100})[0];
      sphere.radius = std::ldexp(1.0, static_cast<int>(random.below(12)) - 4);
      sphere.center[random.below(dim)] -= 1.5 * sphere.radius * random.uniform();
      spheres.push_back(sphere);
    }
    numbers.resize(spheres.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    group.natives = Numbers(natives);
    group.foreigns = Numbers(numbers.data() + natives, foreigns);
    group.visitors = Numbers(numbers.data() + natives + foreigns, visitors);
    grid = TileGrid<dim>::over(group.bounds, cell, 6.0, 1e6);
  }

  abut::testing::NobodyAsked nobody;

  void partition(Tiles<dim>& tiles, std::size_t workers, Simd level = Simd::scalar) {
    tiles.partition({spheres, {}}, group, grid, margin, kernels::element_kernels(level), workers,
                    nobody.work);
  }

  /// Own elements and copies of a tile by the rule, element by element.
  std::vector<std::uint32_t> expected_of(std::size_t tile, bool own) {
    const TileNeighbors<dim> neighbors(grid);
    std::vector<std::uint32_t> result;
    const auto reaches = [&](std::size_t from, auto steps) {
      return std::any_of(steps.begin(), steps.end(),
                         [&](auto k) { return neighbors.from(from, k) == tile; });
    };
    for (std::uint32_t k = 0; k < natives + foreigns; ++k) {
      const bool native = k < natives;
      const auto place =
          native ? grid.place(spheres[k]) : grid.place_of_foreign(spheres[k], group.bounds);
      const bool is_own = native && place.tile == tile;
      const bool is_copy = native ? group.wanted == Wanted::all_pairs &&
                                        reaches(place.tile, neighbors.of_native(place.near_faces))
                                  : reaches(place.tile, neighbors.of_foreign(place.near_faces));
      if (own ? is_own : is_copy) result.push_back(k);
    }
    return result;
  }

  static std::vector<std::uint32_t> numbers_of(std::span<const Record<dim>> records) {
    std::vector<std::uint32_t> result;
    for (const auto& record : records) result.push_back(record.number);
    std::sort(result.begin(), result.end());
    return result;
  }

  static constexpr double cell = 1.1;
  static constexpr double margin = 0.05;
  Spheres<dim> spheres;
  std::vector<std::uint32_t> numbers;
  Group<dim> group;
  TileGrid<dim> grid;
  base::MemoryMeter memory;
};

TYPED_TEST_SUITE(TilesOf, Dimensions);

TYPED_TEST(TilesOf, OwnElementsAndCopiesFollowTheRule) {
  for (const Wanted wanted : {Wanted::all_pairs, Wanted::pairs_of_visitors}) {
    this->group.wanted = wanted;
    Tiles<TypeParam::value> tiles(this->memory);
    this->partition(tiles, 3);
    std::size_t own = 0;
    std::size_t copies = 0;
    for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
      const auto records = tiles.records(tile);
      const std::size_t own_here = tiles.own_count(tile);
      own += own_here;
      ASSERT_EQ(this->numbers_of(records.first(own_here)), this->expected_of(tile, true));
      if (own_here == 0) {
        EXPECT_TRUE(records.empty()) << "without own elements there is no need of copies";
        continue;
      }
      copies += records.size() - own_here;
      ASSERT_EQ(this->numbers_of(records.subspan(own_here)), this->expected_of(tile, false));
    }
    EXPECT_EQ(own, this->natives);
    EXPECT_GT(copies, 100U);
  }
}

TYPED_TEST(TilesOf, RecordsAreTheElementsInSinglePrecision) {
  Tiles<TypeParam::value> tiles(this->memory);
  this->partition(tiles, 1);
  const double unit = tiles.unit();
  int exponent = 0;
  EXPECT_EQ(std::frexp(unit, &exponent), 0.5) << "a power of two";
  for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
    const auto t = this->grid.coordinates(tile);
    const auto records = tiles.records(tile);
    const auto radii = tiles.sizes(tile);
    ASSERT_EQ(radii.size(), records.size()) << "the radii differ";
    for (std::size_t k = 0; k < records.size(); ++k) {
      const auto& record = records[k];
      const auto& sphere = this->spheres[record.number];
      EXPECT_EQ(radii[k], static_cast<float>(sphere.radius * unit));
      for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
        const double position =
            (sphere.center[axis] - this->grid.lower[axis] - t[axis] * this->grid.size[axis]) * unit;
        EXPECT_NEAR(record.center[axis], position, 0x1p-24 * std::fabs(position) + 0x1p-48);
        EXPECT_LE(std::fabs(record.center[axis]), 2.0f);
      }
    }
  }
}

TYPED_TEST(TilesOf, EqualRadiiNeedNoColumn) {
  this->group.bounds.smallest_radius = this->group.bounds.largest_radius;
  Tiles<TypeParam::value> tiles(this->memory);
  this->partition(tiles, 1);
  for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
    EXPECT_TRUE(tiles.sizes(tile).empty());
  }
}

TYPED_TEST(TilesOf, LayoutDoesNotDependOnWorkersAndVectors) {
  Tiles<TypeParam::value> first(this->memory);
  this->partition(first, 1);
  for (const Simd level : testing::simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
      Tiles<TypeParam::value> other(this->memory);
      this->partition(other, workers, level);
      for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
        const auto a = first.records(tile);
        const auto b = other.records(tile);
        ASSERT_EQ(a.size(), b.size());
        ASSERT_EQ(first.own_count(tile), other.own_count(tile));
        ASSERT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
        ASSERT_TRUE(std::ranges::equal(first.sizes(tile), other.sizes(tile)));
        ASSERT_TRUE(std::ranges::equal(first.visitors(tile), other.visitors(tile)));
      }
    }
  }
}

/// Every tile that has an own element within reach of a visitor lists it; each once.
TYPED_TEST(TilesOf, VisitorsAreListedWhereTheyReach) {
  Tiles<TypeParam::value> tiles(this->memory);
  this->partition(tiles, 2);
  std::size_t listed = 0;
  std::size_t needed = 0;
  for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
    const auto listed_here = tiles.visitors(tile);
    std::vector<std::uint32_t> sorted(listed_here.begin(), listed_here.end());
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    listed += sorted.size();
    for (std::size_t v = 0; v < this->group.visitors.size(); ++v) {
      const std::uint32_t visitor = this->group.visitors[v];
      const auto own = tiles.records(tile).first(tiles.own_count(tile));
      const bool reaches = std::any_of(own.begin(), own.end(), [&](const auto& record) {
        return base::within_reach_exactly(this->spheres[visitor], this->spheres[record.number],
                                          this->margin);
      });
      if (!reaches) continue;
      ++needed;
      EXPECT_TRUE(std::binary_search(sorted.begin(), sorted.end(), visitor));
    }
  }
  EXPECT_GT(needed, 100U);
  EXPECT_LE(listed, 3 * needed) << "far more visits than pairs";
}

}  // namespace
}  // namespace abut::engine
