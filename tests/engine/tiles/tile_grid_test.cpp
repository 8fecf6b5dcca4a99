#include "engine/tiles/tile_grid.hpp"

#include "engine/random_spheres.hpp"
#include "kernels/element_kernels.hpp"
#include "kernels/place_format.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class TileGridOf : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;
  using Grid = engine::TileGrid<dim>;

  /// Tile along each axis, counted from 0 in the box.
  static std::array<std::int32_t, dim> along_axes(const Grid& grid, std::uint32_t tile) {
    std::array<std::int32_t, dim> result{};
    auto rest = static_cast<std::int32_t>(tile);
    for (std::size_t axis = dim; axis-- > 0;) {
      result[axis] = rest / grid.stride[axis] - 1;
      rest %= grid.stride[axis];
    }
    return result;
  }

  static grid::Bounds<dim> box(const std::array<double, 3>& lower,
                               const std::array<double, 3>& upper) {
    grid::Bounds<dim> result;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      result.lower[axis] = lower[axis];
      result.upper[axis] = upper[axis];
    }
    return result;
  }
};

TYPED_TEST_SUITE(TileGridOf, Dimensions);

TYPED_TEST(TileGridOf, SlicesLieAlongTheLongestAxis) {
  constexpr int its_dim = TypeParam::value;
  std::array<double, 3> upper{2.0, 3.0, 2.5};
  upper[its_dim - 1] = 30.0;
  for (const double slices : {2.0, 3.0}) {
    const auto grid = engine::TileGrid<its_dim>::slices_of(this->box({}, upper), 1.0, slices);
    EXPECT_EQ(grid.tiles_in_box(), slices);
    for (std::size_t axis = 0; axis < its_dim; ++axis) {
      EXPECT_EQ(grid.count[axis], axis == its_dim - 1 ? static_cast<int>(slices) : 1);
      EXPECT_EQ(grid.size[axis], axis == its_dim - 1 ? 30.0 / slices : upper[axis]);
    }
  }
}

TYPED_TEST(TileGridOf, NoTileIsNarrowerThanAskedForAndNoMoreThanAskedFor) {
  Random random(1);
  for (int k = 0; k < 2000; ++k) {
    std::array<double, 3> upper{};
    for (double& length : upper)
      length = std::ldexp(random.uniform(), static_cast<int>(random.below(20)));
    const double cell = std::ldexp(random.uniform(0.5, 1.0), -static_cast<int>(random.below(6)));
    const double least = random.uniform(1.0, 20.0);
    const double most = std::ldexp(1.0, static_cast<int>(random.below(20)));
    const auto grid =
        engine::TileGrid<TypeParam::value>::over(this->box({}, upper), cell, least, most);
    EXPECT_LE(grid.tiles_in_box(), most);
    std::size_t framed = 1;
    for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
      ASSERT_GE(grid.count[axis], 1);
      framed *= static_cast<std::size_t>(grid.count[axis]) + 2;
      EXPECT_GT(grid.size[axis], 0.0);
      EXPECT_GE(grid.count[axis] * grid.size[axis], upper[axis] * (1.0 - 0x1p-50));
      if (grid.count[axis] > 1) {
        EXPECT_GE(grid.size[axis], least * cell * (1.0 - 0x1p-50));
      }
    }
    EXPECT_EQ(grid.tile_count, framed);
  }
}

/// A larger position is never in an earlier tile; the ends of the box are in the first and last.
TYPED_TEST(TileGridOf, PlacesAreMonotone) {
  const double upper = 1000.0 / 3.0;
  const auto grid = engine::TileGrid<TypeParam::value>::over(
      this->box({-7.3, -7.3, -7.3}, {upper, upper, upper}), 1.0, 18.0, 1e6);
  for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
    ASSERT_GT(grid.count[axis], 10);
    exact::Sphere<TypeParam::value> sphere{};
    std::int32_t last = 0;
    for (std::int32_t face = 0; face <= grid.count[axis]; ++face) {
      double x = std::max(-7.3, std::min(upper, grid.lower[axis] + face * grid.size[axis]));
      for (int step = 0; step < 4; ++step) x = std::max(-7.3, std::nextafter(x, -1e9));
      for (int step = 0; step < 8; ++step, x = std::min(upper, std::nextafter(x, 1e9))) {
        sphere.center[axis] = x;
        const auto place = grid.place(sphere);
        const std::int32_t t = this->along_axes(grid, place.tile)[axis];
        EXPECT_GE(t, last);
        EXPECT_LE(t - last, 1);
        EXPECT_LT(t, grid.count[axis]);
        last = t;
        // So near a face of two tiles that it has copies on the other side.
        if (face > 0 && face < grid.count[axis]) {
          EXPECT_NE(place.near_faces >> (2 * axis) & (t == face ? 1u : 2u), 0u);
        }
      }
    }
    EXPECT_EQ(last, grid.count[axis] - 1);
  }
}

/// An element within a cell of a face has it among its near ones; in the middle of a wide tile
/// none.
TYPED_TEST(TileGridOf, NearIsWithinACell) {
  Random random(2);
  const auto grid =
      engine::TileGrid<TypeParam::value>::over(this->box({}, {90, 90, 90}), 1.0, 18.0, 1e6);
  for (int k = 0; k < 20000; ++k) {
    const auto sphere = random_spheres<TypeParam::value>(random, 1, {90, 90, 90})[0];
    const auto [tile, near_faces] = grid.place(sphere);
    const auto t = grid.coordinates(tile);
    for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
      const double from_lower =
          sphere.center[axis] - (grid.lower[axis] + t[axis] * grid.size[axis]);
      const double from_upper = grid.size[axis] - from_lower;
      EXPECT_EQ((near_faces >> (2 * axis) & 1) != 0, from_lower <= 1.0);
      EXPECT_EQ((near_faces >> (2 * axis + 1) & 1) != 0, from_upper <= 1.0);
    }
  }
}

TYPED_TEST(TileGridOf, FlatAndPointLikeBoxes) {
  for (const std::array<double, 3>& upper :
       {std::array{0.0, 0.0, 0.0}, std::array{100.0, 0.0, 0.0}, std::array{0.0, 100.0, 0.0}}) {
    const auto grid =
        engine::TileGrid<TypeParam::value>::over(this->box({}, upper), 1.0, 18.0, 64.0);
    for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
      EXPECT_EQ(grid.count[axis], upper[axis] == 0.0 ? 1 : 5);
      EXPECT_GT(grid.size[axis], 0.0);
      EXPECT_TRUE(std::isfinite(grid.inverse_size[axis]));
      exact::Sphere<TypeParam::value> end{};
      end.center[axis] = upper[axis];
      EXPECT_EQ(this->along_axes(grid, grid.place(end).tile)[axis], grid.count[axis] - 1);
    }
  }
}

/// What lies outside the box is in the frame, near faces towards the box only.
TYPED_TEST(TileGridOf, HaloElementsAreInTheFrame) {
  Random random(3);
  const auto bounds = this->box({}, {60, 60, 60});
  const auto grid = engine::TileGrid<TypeParam::value>::over(bounds, 1.0, 18.0, 1e6);
  for (int k = 0; k < 20000; ++k) {
    auto sphere = random_spheres<TypeParam::value>(random, 1, {60, 60, 60})[0];
    const std::size_t axis = random.below(TypeParam::value);
    const bool below = random.below(2) == 0;
    const double beyond = random.uniform(1e-12, 1.0);
    sphere.center[axis] = below ? -beyond : 60.0 + beyond;
    const auto [tile, near_faces] = grid.place_of_halo(sphere, bounds);
    EXPECT_EQ(this->along_axes(grid, tile)[axis], below ? -1 : grid.count[axis]);
    EXPECT_EQ(near_faces >> (2 * axis) & 3u, below ? 2u : 1u);
    sphere.center[axis] = below ? -3.0 : 63.0;
    EXPECT_EQ(grid.place_of_halo(sphere, bounds).near_faces >> (2 * axis) & 3u, 0u);
  }
}

/// The vector kernels place whole vectors; each as place() does.
TYPED_TEST(TileGridOf, VectorsPlaceTheSame) {
  Random random(4);
  const auto spheres = random_spheres<TypeParam::value>(random, 5003, {90, 70, 50});
  const auto grid =
      engine::TileGrid<TypeParam::value>::over(bounds_of<TypeParam::value>(spheres), 1.0, 2.0, 1e6);
  for (const Simd level : testing::simd_levels_here()) {
    std::vector<std::uint32_t> places(spheres.size());
    const std::size_t placed = kernels::element_kernels(level).place(
        spheres[0].center, spheres.size(), TypeParam::value, grid.place_map(), places.data());
    EXPECT_LE(placed, spheres.size());
    EXPECT_GE(placed, level == Simd::scalar ? 0 : spheres.size() - 15);
    for (std::size_t k = 0; k < placed; ++k) {
      const auto [tile, near_faces] = grid.place(spheres[k]);
      ASSERT_EQ(places[k], kernels::packed_place(tile, near_faces))
          << name_of(level) << ", element " << k;
    }
  }
}

}  // namespace
}  // namespace abut::testing
