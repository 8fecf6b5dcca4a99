#include "engine/tiles/tiles.hpp"

#include "engine/random_spheres.hpp"
#include "engine/tiles/tile_neighbors.hpp"
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

namespace abut::testing {
namespace {

template <class Dimension>
class TilesOf : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;
  static constexpr std::size_t locals = 6000;
  static constexpr std::size_t halo = 500;
  static constexpr std::size_t coarse_elements = 60;

  /// Locals in the box, halo elements less than a cell outside it, coarse elements of any size
  /// anywhere.
  TilesOf() {
    Random random(6);
    const std::array<double, 3> extent{60, 50, 40};
    spheres = random_spheres<dim>(random, locals, extent);
    set.bounds = bounds_of<dim>(spheres);
    set.bounds.largest_radius = 0.5;
    for (std::size_t k = 0; k < halo; ++k) {
      auto sphere = random_spheres<dim>(random, 1, extent)[0];
      const std::size_t axis = random.below(dim);
      const double beyond = random.uniform(1e-9, cell);
      sphere.center[axis] =
          random.below(2) == 0 ? set.bounds.lower[axis] - beyond : set.bounds.upper[axis] + beyond;
      spheres.push_back(sphere);
    }
    for (std::size_t k = 0; k < coarse_elements; ++k) {
      auto sphere = random_spheres<dim>(random, 1, {100, 100, 100})[0];
      sphere.radius = std::ldexp(1.0, static_cast<int>(random.below(12)) - 4);
      sphere.center[random.below(dim)] -= 1.5 * sphere.radius * random.uniform();
      spheres.push_back(sphere);
    }
    numbers.resize(spheres.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    set.locals = engine::Numbers(locals);
    set.halo = engine::Numbers(numbers.data() + locals, halo);
    set.coarse_elements = engine::Numbers(numbers.data() + locals + halo, coarse_elements);
    grid = engine::TileGrid<dim>::over(set.bounds, cell, 6.0, 1e6);
  }

  abut::testing::NobodyAsked nobody;

  void partition(engine::Tiles<dim>& tiles, std::size_t workers, Simd level = Simd::scalar) {
    const exact::Elements<dim> elements{spheres, {}};
    const auto& kernels = kernels::element_kernels(level);
    const auto counted = tiles.count(elements, set, grid, kernels, workers, nobody.work);
    tiles.sort(elements, set, grid, margin, kernels, workers, nobody.work);
    std::uint64_t records = 0;
    for (std::size_t tile = 0; tile < grid.tile_count; ++tile) {
      records += tiles.records(tile).size();
    }
    EXPECT_EQ(counted, records);
  }

  /// Own elements and copies of a tile by the rule, element by element.
  std::vector<std::uint32_t> expected_of(std::size_t tile, bool own) {
    const engine::TileNeighbors<dim> neighbors(grid);
    std::vector<std::uint32_t> result;
    const auto reaches = [&](std::size_t from, auto steps) {
      return std::any_of(steps.begin(), steps.end(),
                         [&](auto k) { return neighbors.from(from, k) == tile; });
    };
    for (std::uint32_t k = 0; k < locals + halo; ++k) {
      const bool local = k < locals;
      const auto place =
          local ? grid.place(spheres[k]) : grid.place_of_halo(spheres[k], set.bounds);
      const bool is_own = local && place.tile == tile;
      const bool is_copy = local ? set.wanted == engine::Wanted::all_pairs &&
                                       reaches(place.tile, neighbors.of_local(place.near_faces))
                                 : reaches(place.tile, neighbors.of_halo(place.near_faces));
      if (own ? is_own : is_copy) result.push_back(k);
    }
    return result;
  }

  static std::vector<std::uint32_t> numbers_of(std::span<const engine::Record<dim>> records) {
    std::vector<std::uint32_t> result;
    for (const auto& record : records) result.push_back(record.number);
    std::sort(result.begin(), result.end());
    return result;
  }

  static constexpr double cell = 1.1;
  static constexpr double margin = 0.05;
  Spheres<dim> spheres;
  std::vector<std::uint32_t> numbers;
  engine::SearchSet<dim> set;
  engine::TileGrid<dim> grid;
  base::MemoryMeter memory;
};

TYPED_TEST_SUITE(TilesOf, Dimensions);

TYPED_TEST(TilesOf, OwnElementsAndCopiesFollowTheRule) {
  for (const engine::Wanted wanted : {engine::Wanted::all_pairs, engine::Wanted::pairs_of_coarse}) {
    this->set.wanted = wanted;
    engine::Tiles<TypeParam::value> tiles(this->memory);
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
    EXPECT_EQ(own, this->locals);
    EXPECT_GT(copies, 100U);
  }
}

TYPED_TEST(TilesOf, RecordsAreTheElementsInSinglePrecision) {
  engine::Tiles<TypeParam::value> tiles(this->memory);
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
  this->set.bounds.smallest_radius = this->set.bounds.largest_radius;
  engine::Tiles<TypeParam::value> tiles(this->memory);
  this->partition(tiles, 1);
  for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
    EXPECT_TRUE(tiles.sizes(tile).empty());
  }
}

TYPED_TEST(TilesOf, LayoutDoesNotDependOnWorkersAndVectors) {
  engine::Tiles<TypeParam::value> first(this->memory);
  this->partition(first, 1);
  for (const Simd level : testing::simd_levels_here()) {
    for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
      engine::Tiles<TypeParam::value> other(this->memory);
      this->partition(other, workers, level);
      for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
        const auto a = first.records(tile);
        const auto b = other.records(tile);
        ASSERT_EQ(a.size(), b.size());
        ASSERT_EQ(first.own_count(tile), other.own_count(tile));
        ASSERT_TRUE(a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
        ASSERT_TRUE(std::ranges::equal(first.sizes(tile), other.sizes(tile)));
        ASSERT_TRUE(std::ranges::equal(first.coarse_elements(tile), other.coarse_elements(tile)));
      }
    }
  }
}

/// Every tile that has an own element within reach of a coarse element lists it; each once.
TYPED_TEST(TilesOf, CoarseElementsAreListedWhereTheyReach) {
  engine::Tiles<TypeParam::value> tiles(this->memory);
  this->partition(tiles, 2);
  std::size_t listed = 0;
  std::size_t needed = 0;
  for (std::size_t tile = 0; tile < this->grid.tile_count; ++tile) {
    const auto listed_here = tiles.coarse_elements(tile);
    std::vector<std::uint32_t> sorted(listed_here.begin(), listed_here.end());
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    listed += sorted.size();
    for (std::size_t v = 0; v < this->set.coarse_elements.size(); ++v) {
      const std::uint32_t coarse = this->set.coarse_elements[v];
      const auto own = tiles.records(tile).first(tiles.own_count(tile));
      const bool reaches = std::any_of(own.begin(), own.end(), [&](const auto& record) {
        return exact::within_reach_exactly(this->spheres[coarse], this->spheres[record.number],
                                           this->margin);
      });
      if (!reaches) continue;
      ++needed;
      EXPECT_TRUE(std::binary_search(sorted.begin(), sorted.end(), coarse));
    }
  }
  EXPECT_GT(needed, 100U);
  EXPECT_LE(listed, 3 * needed) << "far more visits than pairs";
}

}  // namespace
}  // namespace abut::testing
