#include "engine/tiles/tile_cells.hpp"

#include "engine/random_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abut::testing {
namespace {

template <class Dimension>
class TileCellsOf : public ::testing::Test {};
TYPED_TEST_SUITE(TileCellsOf, Dimensions);

/// A grid of one tile with the given sides in cells.
template <int Dim>
engine::TileGrid<Dim> one_tile(const std::array<double, 3>& sides) {
  engine::TileGrid<Dim> grid;
  grid.cell_size = 1.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    grid.size[axis] = sides[axis];
    grid.inverse_size[axis] = 1.0 / sides[axis];
    grid.count[axis] = 1;
  }
  return grid;
}

/// No cell is narrower than the reach; not many more cells than wanted; a row for eight elements
/// but in small tiles; coarse only if the reach would allow more.
TYPED_TEST(TileCellsOf, AreNeitherTooSmallNorTooMany) {
  Random random(8);
  for (int k = 0; k < 5000; ++k) {
    std::array<double, 3> sides{};
    for (double& side : sides)
      side = std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.below(24)));
    const auto grid = one_tile<TypeParam::value>(sides);
    const double unit = 0x1p-24;
    const std::size_t elements = random.below(5000);
    const double wanted = k % 2 == 0 ? engine::cells_of_even_tile : engine::cells_of_clustered_tile;
    const auto cells = engine::choose_tile_cells(grid, unit, elements, wanted);
    double total = 1.0;
    double finest = 1.0;
    for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
      ASSERT_GE(cells.count[axis], 1);
      EXPECT_LE(cells.count[axis], 1024);
      EXPECT_TRUE(cells.count[axis] == 1 || sides[axis] / cells.count[axis] >= 1.0);
      total *= cells.count[axis];
      finest *= std::max(1.0, std::floor(sides[axis]));
      const double side = cells.size_in_unit(grid, unit)[axis];
      EXPECT_NEAR(side * cells.per_unit[axis], 1.0, 1e-6);
      EXPECT_GE(static_cast<float>(sides[axis] * unit) * cells.per_unit[axis],
                static_cast<float>(cells.count[axis]))
          << "the upper face of the tile lies behind its last cell";
    }
    EXPECT_LE(total, wanted * static_cast<double>(elements) + 8.0);
    EXPECT_LE(total / cells.count[0], static_cast<double>(elements) / 8.0 + 512.0);
    EXPECT_EQ(cells.coarse, total < finest);
  }
}

TYPED_TEST(TileCellsOf, VolumeIsThatOfACell) {
  const auto grid = one_tile<TypeParam::value>({8.0, 4.0, 2.0});
  const auto cells = engine::choose_tile_cells(grid, 0.125, 100000);
  EXPECT_FALSE(cells.coarse);
  EXPECT_EQ(cells.count[0], 8);
  EXPECT_EQ(cells.count[1], 4);
  EXPECT_EQ(cells.volume_in(grid, 0.5), TypeParam::value == 2 ? 4.0 : 8.0);
}

}  // namespace
}  // namespace abut::testing
