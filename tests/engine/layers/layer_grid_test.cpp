#include "engine/layers/layer_grid.hpp"

#include "engine/layers/layer_scenes.hpp"
#include "engine/random_spheres.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace abut::testing {
namespace {

/// Units that a reach has at most, where positions fit.
constexpr double most_units = 1 << kernels::most_cell_bits;

template <class Grid>
double units_of_cell(const Grid& grid) {
  return std::ldexp(1.0, grid.cell_shift());
}

template <class Dimension>
class LayerGridOf : public ::testing::Test {
 protected:
  static constexpr std::size_t axes = Dimension::value;
  using Grid = engine::LayerGrid<Dimension::value>;
  using Sphere = exact::Sphere<Dimension::value>;

  static grid::Bounds<Dimension::value> box(const std::array<double, 3>& extent) {
    grid::Bounds<Dimension::value> bounds;
    bounds.include_center(sphere_at<Dimension::value>({0.0, 0.0, 0.0}));
    bounds.include_center(sphere_at<Dimension::value>(extent));
    return bounds;
  }

  /// Cells along an axis of the box, counted from the positions of its upper corner.
  static std::uint32_t cells(const Grid& grid, const std::array<double, 3>& extent,
                             std::size_t axis) {
    const auto record = grid.record(sphere_at<Dimension::value>(extent), 0);
    return (static_cast<std::uint32_t>(record.position[axis]) >> grid.cell_shift()) + 1;
  }

  static kernels::LayerPair reach_of(const Grid& grid) {
    kernels::LayerPair layers{};
    grid.set_reach(layers);
    return layers;
  }

  Random random_{static_cast<std::uint64_t>(61 + axes)};
};

TYPED_TEST_SUITE(LayerGridOf, Dimensions);

/// All orders of three extents.
constexpr std::array<std::array<double, 3>, 6> shapes{{{10.0, 20.0, 40.0},
                                                       {10.0, 40.0, 20.0},
                                                       {20.0, 10.0, 40.0},
                                                       {20.0, 40.0, 10.0},
                                                       {40.0, 10.0, 20.0},
                                                       {40.0, 20.0, 10.0}}};

TYPED_TEST(LayerGridOf, LayersGoAlongTheLongestAxisAndRowsAlongTheNext) {
  for (const auto& extent : shapes) {
    const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 10000);
    ASSERT_TRUE(grid);
    const auto wide = [&](std::size_t axis) { return extent[axis]; };
    const auto layer_axis = static_cast<std::size_t>(grid->map().layer_axis);
    for (std::size_t axis = 0; axis < TestFixture::axes; ++axis) {
      EXPECT_LE(wide(axis), wide(layer_axis));
      EXPECT_TRUE(axis == layer_axis || wide(axis) <= wide(grid->row_axis()));
    }
    EXPECT_NE(grid->row_axis(), layer_axis);
  }
}

TYPED_TEST(LayerGridOf, SpheresAndTheirRecordsAgree) {
  constexpr int dim = TypeParam::value;
  for (const auto& extent : shapes) {
    for (const double cell : {0.37, 1.0, 3.3}) {
      auto spheres = uniform_spheres<dim>(this->random_, 2000, extent);
      // Far from the origin, where sums would be rounded more than differences are.
      for (auto& sphere : spheres) {
        for (double& x : sphere.center) x += 0x1p36 + 0.1;
      }
      const auto grid =
          layer_grid_over<TypeParam::value>(bounds_of<dim>(spheres), cell, cell, 10000);
      ASSERT_TRUE(grid);
      std::uint32_t number = 7;
      for (const auto& sphere : spheres) {
        const kernels::PositionRecord record = grid->record(sphere, number);
        EXPECT_EQ(record.number, number++);
        EXPECT_EQ(grid->layer(record), grid->layer(sphere));
        EXPECT_LT(grid->layer(record), grid->layer_count());
        EXPECT_LT(grid->row(record), grid->row_count());
        EXPECT_LT(grid->column(record), grid->column_count());
        EXPECT_TRUE(dim == 3 || record.position[2] == 0);
      }
    }
  }
}

/// Position, layer, row and column as floor((x - lower) / cell) says, on faces and beside them.
TYPED_TEST(LayerGridOf, PositionsAreWholeUnitsFromTheLowerCorner) {
  const std::array<double, 3> extent{16.0, 24.0, 32.0};
  const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 20000);
  ASSERT_TRUE(grid);
  ASSERT_EQ(grid->map().units_of_one, most_units);
  for (std::size_t axis = 0; axis < TestFixture::axes; ++axis) {
    for (const double x : {0.0, 0.25, 1.0, 7.0, 8.0, 15.0, extent[axis]}) {
      for (const double beside : {x, std::nextafter(x, 0.0), std::nextafter(x, extent[axis])}) {
        std::array<double, 3> center{};
        center[axis] = beside;
        const auto record = grid->record(sphere_at<TypeParam::value>(center), 0);
        EXPECT_EQ(record.position[axis], static_cast<std::int32_t>(beside * most_units));
        if (axis == grid->row_axis()) {
          const double columns = std::ldexp(beside, grid->cell_shift() - grid->column_shift());
          EXPECT_EQ(grid->column(record), static_cast<std::uint32_t>(columns));
        }
      }
    }
  }
}

/// In 2D a layer is a strip of rows, of which the last may have fewer; in 3D one row of cells.
TYPED_TEST(LayerGridOf, LayersHoldRowAfterRow) {
  constexpr bool has_strips = TypeParam::value == 2;
  for (const std::size_t elements : {300U, 9000U, 100000U, 1000000U, 20000000U, 400000000U}) {
    const double side = std::pow(static_cast<double>(elements), 1.0 / TypeParam::value);
    const std::array<double, 3> extent{side, side + 1.5, side + 2.5};
    const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.001, elements);
    ASSERT_TRUE(grid);
    const std::size_t axis = TypeParam::value - 1;
    const std::uint32_t along = this->cells(*grid, extent, axis);
    const std::uint32_t in_layer = has_strips ? grid->row_count() : 1;
    EXPECT_EQ(grid->layer_count(), (along - 1) / in_layer + 1);
    for (int k = 0; k < 300; ++k) {
      const auto sphere = uniform_spheres<TypeParam::value>(this->random_, 1, extent)[0];
      const auto record = grid->record(sphere, 0);
      const auto cell = static_cast<std::uint32_t>(record.position[axis]) >> grid->cell_shift();
      EXPECT_EQ(grid->layer(sphere), cell / in_layer);
      EXPECT_TRUE(!has_strips || grid->row(record) == cell % in_layer);
    }
    if (!has_strips || grid->layer_count() == 1) continue;
    const double in_row = static_cast<double>(elements) / along;
    // A strip has as many rows, a power of two, as fit into that many elements: up to four even if
    // they are long.
    const double in_four = std::min(4.0 * in_row, 32768.0);
    const auto count = static_cast<double>(elements);
    const double least = std::min(512.0, 0.5 * count);
    const double in_strip = std::min(std::max(4096.0, in_four), std::max(count / 24.0, least));
    EXPECT_LE(in_row * in_layer, std::max(in_strip, in_row));
    EXPECT_GT(2.0 * in_row * in_layer, in_strip);
  }
}

TYPED_TEST(LayerGridOf, FewElementsHaveAsFewRowsAsAnAxisHasCells) {
  for (const std::size_t elements : {1U, 2U, 3U, 17U}) {
    const auto grid =
        layer_grid_over<TypeParam::value>(this->box({2.5, 2.5, 2.5}), 1.0, 1.001, elements);
    ASSERT_TRUE(grid);
    EXPECT_LT(grid->map().layer_shift, 32);
    EXPECT_LE(grid->row_count(), 2048U);
    EXPECT_EQ(grid->layer(sphere_at<TypeParam::value>({0.0, 0.0, 0.0})), 0U);
    EXPECT_EQ(grid->layer(sphere_at<TypeParam::value>({2.5, 2.5, 2.5})), grid->layer_count() - 1);
  }
}

/// Cells of 2^22 to 2^16 units along an axis, and some to spare: the difference of two positions,
/// or of one and the far position, has 31 bits and a sign.
TYPED_TEST(LayerGridOf, PositionsHaveAnEnd) {
  struct Axis {
    double cells;
    int bits;
  };
  constexpr std::array<Axis, 11> ends{{{509.0, 22},
                                       {509.4, 22},
                                       {509.6, 21},
                                       {1020.9, 21},
                                       {1021.1, 20},
                                       {2043.5, 20},
                                       {2044.1, 19},
                                       {4089.9, 19},
                                       {4090.1, 18},
                                       {16366.1, 16},
                                       {32733.5, 16}}};
  for (std::size_t axis = 0; axis < TestFixture::axes; ++axis) {
    std::array<double, 3> extent{40.0, 40.0, 40.0};
    for (const auto& [cells, bits] : ends) {
      extent[axis] = cells;
      const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 1U << 30);
      ASSERT_TRUE(grid);
      EXPECT_EQ(grid->cell_shift(), bits) << cells;
      EXPECT_EQ(grid->far_position(), -(2 << bits));
      const auto last = grid->record(sphere_at<TypeParam::value>(extent), 0).position[axis];
      EXPECT_LT(last, kernels::end_of_positions(bits));
      EXPECT_LT(std::int64_t{last} - grid->far_position(), std::int64_t{1} << 31);
    }
    extent[axis] = 32734.5;
    EXPECT_FALSE(layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 1U << 30));
    extent[axis] = 1e300;
    EXPECT_FALSE(layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 1U << 30));
  }
}

/// What is within reach is no more columns away than the table says, and no more than a row and a
/// layer; what is in a column further is beyond the outer bound of the filter.
TYPED_TEST(LayerGridOf, ColumnsInReachCoverIt) {
  const std::array<double, 3> extent{20.0, 21.0, 22.0};
  for (const double reach : {1.0, 0.999, 0.75, 0.5, 0.26, 0.25, 0.1, 0.0}) {
    const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), reach, 1.001, 20000);
    ASSERT_TRUE(grid);
    const std::uint32_t covered = grid->columns_in_reach();
    for (int k = 0; k < 2000; ++k) {
      auto sphere = uniform_spheres<TypeParam::value>(this->random_, 1, extent)[0];
      const std::size_t axis = this->random_.below(TestFixture::axes);
      // As far into its column or cell as it can be, half of the time.
      const double face = std::ldexp(1.001, axis == grid->row_axis() ? -2 : 0);
      double& x = sphere.center[axis];
      if (k % 2 == 0) x = std::max(0.0, std::nextafter(face * std::floor(x / face), 0.0));
      const auto near = grid->record(sphere, 0);
      x += reach;
      const auto far = grid->record(sphere, 0);
      EXPECT_LE(grid->column(far), grid->column(near) + covered);
      EXPECT_LE(far.position[axis] >> grid->cell_shift(),
                (near.position[axis] >> grid->cell_shift()) + 1);
    }
    const double beyond = std::ldexp(static_cast<double>(covered), grid->column_shift());
    EXPECT_GT(beyond * beyond, static_cast<double>(this->reach_of(*grid).outer));
  }
}

/// The bounds of the filter stand around the reach, however positions were rounded.
TYPED_TEST(LayerGridOf, TheFilterLeavesAWidthAroundTheReach) {
  for (const double reach : {1.0, 0.3, 1e-5, 0.0}) {
    const auto grid =
        layer_grid_over<TypeParam::value>(this->box({9.0, 9.0, 9.0}), reach, 1.001, 20000);
    ASSERT_TRUE(grid);
    const double units = reach * grid->map().units_of_one;
    const double rounding = std::sqrt(static_cast<double>(TypeParam::value)) + 0.5;
    const kernels::LayerPair layers = this->reach_of(*grid);
    EXPECT_GE(std::sqrt(static_cast<double>(layers.outer)), units + rounding);
    EXPECT_LE(std::sqrt(static_cast<double>(layers.inner)), std::max(0.0, units - rounding));
    EXPECT_GE(layers.band, layers.outer - layers.inner);
  }
}

TYPED_TEST(LayerGridOf, CellsAreNotManyMoreThanElements) {
  for (const double cell : {1.0, 0.1, 1e-9, 0x1p-900}) {
    for (const auto& extent : {std::array{10.0, 10.0, 10.0}, {1.0, 30.0, 30.0}, {9.0, 0.0, 9.0}}) {
      const std::size_t elements = 1000;
      const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), cell, cell, elements);
      ASSERT_TRUE(grid);
      double cells = 1.0;
      for (std::size_t axis = 0; axis < TestFixture::axes; ++axis) {
        const double along =
            std::ldexp(extent[axis] * grid->map().units_of_one, -grid->cell_shift());
        cells *= std::max(1.0, along);
      }
      EXPECT_LE(cells, 3.001 * elements) << cell;
      EXPECT_LE(grid->map().units_of_one, units_of_cell(*grid) / cell);
    }
  }
}

/// The unit is the finest of which a reach has 2^22 at most, in wide cells as well, and with which
/// positions have their 31 bits: half of it has one or the other no more.
TYPED_TEST(LayerGridOf, UnitsAreAsFineAsReachAndPositionsAllow) {
  bool is_as_fine_as_reaches = false;
  bool is_as_fine_as_positions = false;
  for (const double least : {1.0, 0.3, 0.01, 1e-5, 1e-12}) {
    for (const double side : {3.0, 60.0, 1000.0}) {
      const std::array<double, 3> extent{side, 0.9 * side, 0.8 * side};
      const auto grid =
          layer_grid_over<TypeParam::value>(this->box(extent), 0.9 * least, least, 20000);
      ASSERT_TRUE(grid);
      const double units_of_reach = least * grid->map().units_of_one;
      EXPECT_EQ(grid->has_wide_cells(), units_of_reach < units_of_cell(*grid));
      const double units_of_axis = side * grid->map().units_of_one;
      const int reach_bits =
          static_cast<int>(std::bit_width(static_cast<unsigned>(-grid->far_position()))) - 2;
      EXPECT_LE(units_of_reach, std::ldexp(1.0, reach_bits));
      EXPECT_LT(units_of_axis, kernels::end_of_positions(reach_bits));
      const bool fit_no_finer_reach = 2.0 * units_of_reach > most_units;
      const int finer_bits = std::min(reach_bits + 1, kernels::most_cell_bits);
      const bool fit_no_finer_positions =
          2.0 * units_of_axis >= kernels::end_of_positions(finer_bits);
      EXPECT_TRUE(fit_no_finer_reach || fit_no_finer_positions) << least << " " << side;
      is_as_fine_as_reaches |= fit_no_finer_reach && grid->has_wide_cells();
      is_as_fine_as_positions |= fit_no_finer_positions;
      EXPECT_LT(grid->map().layer_shift, 32);
    }
  }
  EXPECT_TRUE(is_as_fine_as_reaches);
  EXPECT_TRUE(is_as_fine_as_positions);
}

TYPED_TEST(LayerGridOf, FlatBoxesAndPoints) {
  constexpr std::array<std::array<double, 3>, 5> flat{
      {{0.0, 0.0, 0.0}, {30.0, 0.0, 0.0}, {0.0, 30.0, 0.0}, {0.0, 0.0, 30.0}, {30.0, 0.0, 20.0}}};
  for (const auto& extent : flat) {
    const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 3000);
    ASSERT_TRUE(grid);
    for (std::size_t axis = 0; axis < TestFixture::axes; ++axis) {
      EXPECT_EQ(this->cells(*grid, extent, axis), extent[axis] > 0.0 ? extent[axis] + 1.0 : 1.0);
    }
    const auto last = grid->record(sphere_at<TypeParam::value>(extent), 0);
    EXPECT_EQ(grid->layer(last), grid->layer_count() - 1);
    EXPECT_LT(grid->row(last), grid->row_count());
    EXPECT_LT(grid->column(last), grid->column_count());
  }
}

/// Radii below the least are not far, and those that are lie hardly above it.
TYPED_TEST(LayerGridOf, FarRadiiHaveALeast) {
  for (const double margin : {0.0, 0.01, 0.7, 2.0}) {
    for (const double cell : {0.37, 1.0, 3.0, 1e3}) {
      SCOPED_TRACE("margin " + std::to_string(margin) + ", cell " + std::to_string(cell));
      auto bounds = this->box({20.0 * cell, 31.0 * cell, 15.0 * cell});
      bounds.smallest_radius = 0.1 * cell;
      bounds.largest_radius = 5.0 * cell;
      const auto grid = TestFixture::Grid::of_cells(bounds, margin * cell, cell, 3000);
      ASSERT_TRUE(grid);
      const double least = grid->least_far_radius();
      const auto is_far = [&](double radius) { return grid->is_far(grid->units_of(radius)); };
      for (int k = 0; k < 1000; ++k) {
        const double below = std::exp2(-this->random_.uniform(0.0, 30.0));
        EXPECT_FALSE(is_far(least - below * std::abs(least)));
      }
      EXPECT_TRUE(is_far(std::max(least, 0.0) + 1e-4 * cell));
    }
  }
}

TYPED_TEST(LayerGridOf, EachCellHasANumberOfItsOwn) {
  const std::array<double, 3> extent{12.5, 10.5, 11.5};
  const auto grid = layer_grid_over<TypeParam::value>(this->box(extent), 1.0, 1.0, 3000);
  ASSERT_TRUE(grid);
  std::set<std::uint64_t> numbers;
  for (const auto& sphere : cubic_lattice<TypeParam::value>(10)) {
    auto within = sphere;
    for (double& x : within.center) x += 0.5;
    EXPECT_EQ(grid->cell(sphere), grid->cell(within));
    EXPECT_TRUE(numbers.insert(grid->cell(sphere)).second);
  }
}

}  // namespace
}  // namespace abut::testing
