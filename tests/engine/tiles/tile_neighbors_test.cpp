#include "engine/tiles/tile_neighbors.hpp"

#include "engine/random_spheres.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>

namespace abut::testing {
namespace {

template <class Dimension>
class TileNeighborsOf : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;
  static constexpr std::uint32_t all_faces = (1u << (2 * dim)) - 1;

  static engine::TileGrid<dim> four_each_way() {
    grid::Bounds<dim> box;
    box.lower.fill(0.0);
    box.upper.fill(80.0);
    return engine::TileGrid<dim>::over(box, 1.0, 20.0, 1e6);
  }
};

TYPED_TEST_SUITE(TileNeighborsOf, Dimensions);

/// Of two neighbouring tiles exactly one sees the locals of the other.
TYPED_TEST(TileNeighborsOf, OneOfEachPairOfTilesSeesTheOther) {
  const engine::TileNeighbors<TypeParam::value> neighbors(this->four_each_way());
  constexpr std::size_t middle = 1000;
  std::set<std::size_t> seen_by;
  for (const auto k : neighbors.of_local(this->all_faces)) {
    seen_by.insert(neighbors.from(middle, k));
  }
  std::set<std::size_t> all;
  for (const auto k : neighbors.of_halo(this->all_faces)) all.insert(neighbors.from(middle, k));
  EXPECT_EQ(all.size(), TypeParam::value == 3 ? 26U : 8U);
  EXPECT_EQ(seen_by.size(), all.size() / 2);
  for (const std::size_t tile : all) {
    EXPECT_NE(seen_by.contains(tile), seen_by.contains(2 * middle - tile)) << tile;
  }
}

/// The neighbours of an element near some faces are those that it can reach: where it is near no
/// face of an axis, no step along it; where it is near one, none the other way.
TYPED_TEST(TileNeighborsOf, StepsLeadThroughNearFacesOnly) {
  const auto grid = this->four_each_way();
  const engine::TileNeighbors<TypeParam::value> neighbors(grid);
  for (std::uint32_t faces = 0; faces <= this->all_faces; ++faces) {
    std::size_t expected = 1;
    for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
      expected *= 1 + (faces >> (2 * axis) & 1) + (faces >> (2 * axis + 1) & 1);
    }
    EXPECT_EQ(neighbors.of_halo(faces).size(), expected - 1);
    std::set<std::size_t> targets;
    for (const auto k : neighbors.of_halo(faces)) {
      targets.insert(neighbors.from(500, k));
      for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
        const int offset = engine::neighbor_offsets<TypeParam::value>[k][axis];
        if (offset != 0) {
          EXPECT_NE(faces >> (2 * axis + (offset > 0 ? 1 : 0)) & 1, 0u);
        }
      }
    }
    EXPECT_EQ(targets.size(), expected - 1) << "each once";
    const auto local = neighbors.of_local(faces);
    const auto halo = neighbors.of_halo(faces);
    EXPECT_TRUE(std::ranges::equal(local, halo.first(local.size())));
  }
}

/// A pair of elements in the corners of neighbouring tiles meets in exactly one tile.
TYPED_TEST(TileNeighborsOf, APairAcrossAFaceMeetsOnce) {
  Random random(5);
  const auto grid = this->four_each_way();
  const engine::TileNeighbors<TypeParam::value> neighbors(grid);
  int across = 0;
  for (int k = 0; k < 50000; ++k) {
    const auto a = random_spheres<TypeParam::value>(random, 1, {80, 80, 80})[0];
    auto b = a;
    for (double& x : b.center) x = std::clamp(x + random.uniform(-0.5, 0.5), 0.0, 80.0);
    const auto place_a = grid.place(a);
    const auto place_b = grid.place(b);
    if (place_a.tile == place_b.tile) continue;
    ++across;
    std::map<std::size_t, int> meets;
    for (const auto n : neighbors.of_local(place_a.near_faces)) {
      if (neighbors.from(place_a.tile, n) == place_b.tile) ++meets[place_b.tile];
    }
    for (const auto n : neighbors.of_local(place_b.near_faces)) {
      if (neighbors.from(place_b.tile, n) == place_a.tile) ++meets[place_a.tile];
    }
    ASSERT_EQ(meets.size(), 1U);
    EXPECT_EQ(meets.begin()->second, 1);
  }
  EXPECT_GT(across, 500);
}

}  // namespace
}  // namespace abut::testing
