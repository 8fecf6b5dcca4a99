// Long cells: each shape of them over sheets, curves and crowds, and when they are taken.

#include "engine/layers/long_cells.hpp"

#include "engine/layers/layer_in_grid.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using engine::LongCells;

/// A cell that a reach of 1 needs.
constexpr double least_cell = 1.001;

constexpr std::size_t few = 3000;

template <class Dimension>
class LongCellsOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using Grid = engine::LayerGrid<its_dim>;

  static std::vector<LongCells> shapes() {
    std::vector<LongCells> all;
    for (std::size_t axis = 0; axis < its_dim; ++axis) {
      all.push_back({axis, LongCells::Along::rows});
      if (its_dim == 3) all.push_back({axis, LongCells::Along::next_rows});
    }
    return all;
  }

  static std::string name_of_shape(const LongCells& shape) {
    return std::string("long on axis ") + "xyz"[shape.axis] +
           (shape.along == LongCells::Along::rows ? ", along rows" : ", from row to row");
  }

  /// Elements near a plane through the origin (a line in 2D) whose slopes are these, an axis turned
  /// to the next one so many times.
  Spheres<its_dim> sheet(std::size_t count, double width, std::size_t turns) {
    Spheres<its_dim> spheres;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = random_.uniform(0.0, width);
      const double y = its_dim == 3 ? random_.uniform(0.0, width) : 0.4 * x;
      std::array<double, 3> center{x, y, 0.6 * x + 0.3 * y + random_.uniform(0.0, 0.2)};
      std::rotate(center.begin(), center.begin() + static_cast<std::ptrdiff_t>(turns % its_dim),
                  center.begin() + its_dim);
      spheres.push_back(sphere_at<its_dim>(center));
    }
    return spheres;
  }

  /// Beads along a line that is parallel to no axis.
  static Spheres<its_dim> string_of_beads(std::size_t count) {
    Spheres<its_dim> spheres;
    for (std::size_t k = 0; k < count; ++k) {
      const double t = 0.9 * static_cast<double>(k);
      spheres.push_back(sphere_at<its_dim>({0.6 * t, 0.64 * t, 0.48 * t}));
    }
    return spheres;
  }

  std::vector<Spheres<its_dim>> scenes() {
    const double width = its_dim == 3 ? 60.0 : 1400.0;
    return {sheet(few, width, 0),
            sheet(few, width, 1),
            sheet(few, width, 2),
            string_of_beads(few),
            uniform_spheres<its_dim>(random_, few, {90.0, 80.0, 70.0}),
            clumps<its_dim>(random_, few, 40, {200.0, 300.0, 100.0}, 1.5)};
  }

  /// Searches in the grid by each level and by one or three workers, always with the same result.
  template <class Elements>
  static LayerRun run_everywhere(const Elements& elements, const Grid& grid, double margin) {
    engine::RowsSettings settings{margin, 1, Simd::scalar, always_in_layers};
    const LayerRun first = run_in_grid(elements, grid, settings);
    for (const Simd level : simd_levels_here()) {
      for (const std::size_t workers : {1U, 3U}) {
        SCOPED_TRACE(std::string(name_of(level)) + ", " + std::to_string(workers) + " workers");
        settings.simd = level;
        settings.workers = workers;
        expect_same(first, run_in_grid(elements, grid, settings));
      }
    }
    return first;
  }

  /// Rods are left out where their layers would be few.
  void expect_right_in_each_shape(const Spheres<its_dim>& spheres, double margin = 0.0) const {
    const auto bounds = bounds_of<its_dim>(spheres);
    const double cell = (2.0 * bounds.largest_radius + margin) * least_cell;
    const PairVector expected = directly_checked<its_dim>(spheres, margin);
    std::size_t searched = 0;
    for (const LongCells& shape : shapes()) {
      SCOPED_TRACE(name_of_shape(shape));
      const auto grid = Grid::of_long_cells(bounds, margin, cell, spheres.size(), shape);
      if (!grid) continue;
      ++searched;
      EXPECT_TRUE(same_pairs(expected, run_everywhere(spheres, *grid, margin).pairs));
    }
    EXPECT_GE(searched, its_dim == 3 ? 3U : 2U);
  }

  Random random_{static_cast<std::uint64_t>(171 + its_dim)};
};

TYPED_TEST_SUITE(LongCellsOf, Dimensions);

TYPED_TEST(LongCellsOf, NoMoreCellsThanElementsAreWorth) {
  constexpr int dim = TypeParam::value;
  for (const double width : {40.0, 1e3, 1e5, 1e9}) {
    for (const std::size_t count : {std::size_t{300}, std::size_t{20000}, std::size_t{3000000}}) {
      grid::Bounds<dim> bounds;
      bounds.include_center(sphere_at<dim>({0.0, 0.0, 0.0}));
      bounds.include_center(sphere_at<dim>({width, 0.7 * width, 0.9 * width}));
      for (int k = 0; k < 2; ++k) bounds.include_radius(half);
      for (const LongCells& shape : this->shapes()) {
        SCOPED_TRACE(this->name_of_shape(shape) + ", width " + std::to_string(width) + ", " +
                     std::to_string(count) + " elements");
        const auto grid =
            engine::LayerGrid<dim>::of_long_cells(bounds, 0.0, least_cell, count, shape);
        if (!grid) continue;  // layers would be few
        const double layers = grid->layer_count();
        const double rows = layers * grid->row_count();
        const double columns = grid->column_count() + 2.0 * grid->columns_in_reach();
        EXPECT_GE(dim == 2 ? rows : layers, 24.0);
        EXPECT_LE(rows * columns, 25.0 * static_cast<double>(count));
        EXPECT_LE(rows, static_cast<double>(count));
        EXPECT_LE(8.0 * layers, static_cast<double>(count));
      }
    }
  }
}

TYPED_TEST(LongCellsOf, FewElementsOrFewLayersHaveNone) {
  constexpr int dim = TypeParam::value;
  grid::Bounds<dim> bounds;
  bounds.include_center(sphere_at<dim>({0.0, 0.0, 0.0}));
  bounds.include_center(sphere_at<dim>({20.0, 20.0, 20.0}));
  for (int k = 0; k < 2; ++k) bounds.include_radius(half);
  for (const LongCells& shape : this->shapes()) {
    SCOPED_TRACE(this->name_of_shape(shape));
    EXPECT_FALSE(engine::LayerGrid<dim>::of_long_cells(bounds, 0.0, least_cell, 100000, shape));
    EXPECT_FALSE(engine::LayerGrid<dim>::of_long_cells(bounds, 0.0, least_cell, 1, shape));
  }
}

/// Also where the box has more cells along an axis than positions have bits for.
TYPED_TEST(LongCellsOf, ElementsWithinReachAreInAdjacentCells) {
  constexpr int dim = TypeParam::value;
  for (const double width : {60.0, 5e3, 4e5, 1e8}) {
    grid::Bounds<dim> bounds;
    bounds.include_center(sphere_at<dim>({-1.0, -1.0, -1.0}));
    bounds.include_center(sphere_at<dim>({width, 0.8 * width, 0.6 * width}));
    for (int k = 0; k < 2; ++k) bounds.include_radius(half);
    for (const LongCells& shape : this->shapes()) {
      SCOPED_TRACE(this->name_of_shape(shape) + ", width " + std::to_string(width));
      const auto grid =
          engine::LayerGrid<dim>::of_long_cells(bounds, 0.0, least_cell, 40000, shape);
      ASSERT_TRUE(grid);
      for (int k = 0; k < 2000; ++k) {
        auto one = uniform_spheres<dim>(this->random_, 1, {width, 0.8 * width, 0.6 * width})[0];
        auto other = one;
        other.center[static_cast<std::size_t>(k) % dim] -= 1.0;
        const auto first = grid->record(one, 0);
        const auto second = grid->record(other, 0);
        const auto apart = [](std::uint32_t a, std::uint32_t b) {
          return std::abs(static_cast<std::int64_t>(a) - static_cast<std::int64_t>(b));
        };
        const auto row = [&](const kernels::PositionRecord& record) {
          return dim == 2 ? grid->layer(record) * grid->row_count() + grid->row(record)
                          : grid->row(record);
        };
        ASSERT_LE(apart(grid->layer(first), grid->layer(second)), 1);
        ASSERT_LE(apart(row(first), row(second)), 1);
        ASSERT_LE(apart(grid->column(first), grid->column(second)), grid->columns_in_reach());
      }
    }
  }
}

TYPED_TEST(LongCellsOf, EachShapeHasThePairs) {
  constexpr int dim = TypeParam::value;
  for (const auto& spheres : this->scenes()) {
    this->expect_right_in_each_shape(spheres);
    this->expect_right_in_each_shape(spheres, 0.3);
  }
  auto spheres = this->sheet(few, dim == 3 ? 60.0 : 1400.0, 1);
  for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.2, half);
  this->expect_right_in_each_shape(spheres, 0.1);
}

/// Neighbors that touch, or fail to by a last place, on a staircase of unit steps.
TYPED_TEST(LongCellsOf, PairsAtTheReach) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  std::array<double, 3> at{0.5, 0.5, 0.5};
  for (std::size_t k = 0; k < few; ++k) {
    spheres.push_back(sphere_at<dim>(at));
    double& x = at[k % dim];
    x = beside(this->random_, x + 1.0);
  }
  this->expect_right_in_each_shape(spheres);
}

TYPED_TEST(LongCellsOf, EachShapeHasThePairsOfBoxes) {
  constexpr int dim = TypeParam::value;
  const std::array<double, 3> extent{400.0, 300.0, 200.0};
  Boxes<dim> boxes;
  for (const auto& sphere : this->sheet(few, dim == 3 ? 60.0 : 1400.0, 0)) {
    std::array<double, 3> lower{};
    std::copy_n(sphere.center, dim, lower.begin());
    boxes.push_back(box_at<dim>(lower, {this->random_.uniform(0.0, 1.0), 1.0, 0.5}));
  }
  append<dim>(boxes, uniform_boxes<dim>(this->random_, few, extent));
  const auto bounds = bounds_of_boxes<dim>(boxes);
  const PairVector expected = directly_checked<dim>(boxes, 0.0);
  for (const LongCells& shape : this->shapes()) {
    SCOPED_TRACE(this->name_of_shape(shape));
    const auto grid =
        engine::LayerGrid<dim>::of_long_cells(bounds, 0.0, least_cell, boxes.size(), shape);
    ASSERT_TRUE(grid);
    EXPECT_TRUE(same_pairs(expected, this->run_everywhere(boxes, *grid, 0.0).pairs));
  }
}

/// Cubes of a sheet, and of a curve, would hold the more elements the more there are of these.
TYPED_TEST(LongCellsOf, SheetsAndCurvesTakeFewTests) {
  constexpr int dim = TypeParam::value;
  constexpr std::size_t many = 20000;
  std::vector<Spheres<dim>> all{this->string_of_beads(many)};
  for (const std::size_t turns : {0U, 1U, 2U}) {
    all.push_back(this->sheet(many, dim == 3 ? 130.0 : 8000.0, turns));
  }
  for (const auto& spheres : all) {
    const engine::RowsSettings settings{0.0, 1, Simd::scalar, {}};
    const LayerRun run = run_rows<dim>(spheres, settings);
    EXPECT_TRUE(run.in_layers);
    EXPECT_TRUE(same_pairs(directly_checked<dim>(spheres, 0.0), run.pairs));
    EXPECT_LE(run.candidate_tests, 22 * many);
  }
}

}  // namespace
}  // namespace abut::testing
