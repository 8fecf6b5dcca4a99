#include "engine/tiles/cross_level_runs.hpp"

#include "engine/random_spheres.hpp"
#include "engine/tiles/sorted_tile.hpp"
#include "support/nobody_asked.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace abut::testing {
namespace {

template <int Dim>
exact::Elements<Dim> just(const exact::Sphere<Dim>& coarse) {
  return {std::span(&coarse, 1), {}};
}

template <class Dimension>
class CrossLevelRunsOf : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;
  static constexpr double largest_radius = 0.02;
  static constexpr double margin = 0.005;

  /// Own elements, as large as any, whose cell ends or begins where they are.
  static bool is_on_a_face(std::size_t k) { return k < 3000 && k % 10 == 0; }

  /// 3000 own elements in a tile of side 0.9 at the corner (5, 5, 5), and copies around it.
  CrossLevelRunsOf() : tile(memory), cross_level(memory) {
    Random random(11);
    grid.cell_size = 0.046;
    for (std::size_t axis = 0; axis < dim; ++axis) {
      grid.size[axis] = 0.9;
      grid.inverse_size[axis] = 1.0 / 0.9;
      grid.count[axis] = 1;
      grid.lower[axis] = 5.0;
    }
    const auto cells = engine::choose_tile_cells(grid, 1.0, 3300);
    frame.cell_size = cells.size_in_unit(grid, 1.0);
    for (std::size_t k = 0; k < 3300; ++k) {
      const bool own = k < 3000;
      exact::Sphere<dim> sphere{};
      engine::Record<dim> record{};
      for (std::size_t axis = 0; axis < dim; ++axis) {
        sphere.center[axis] = random.uniform(5.0, 5.9);
        if (!own && axis == k % dim) sphere.center[axis] = 4.98;
        if (axis == 0 && is_on_a_face(k)) {
          const double face = std::floor((sphere.center[0] - 5.0) / frame.cell_size[0]);
          sphere.center[0] = 5.0 + face * frame.cell_size[0] + random.uniform(-1e-5, 1e-5);
        }
        record.center[axis] = static_cast<float>(sphere.center[axis] - 5.0);
      }
      sphere.radius = largest_radius * (is_on_a_face(k) ? 1.0 : random.uniform());
      radii.push_back(static_cast<float>(sphere.radius));
      record.number = static_cast<std::uint32_t>(k);
      spheres.push_back(sphere);
      records.push_back(record);
    }
    const auto kernels = kernels::element_kernels(Simd::scalar);
    abut::testing::NobodyAsked nobody;
    tile.count(records, 3000, cells, kernels, nobody.work);
    tile.sort(records, {kernels::ElementShape::spheres, radii, 0.0f}, kernels, nobody.work);
    frame.largest_radius = largest_radius;
    frame.margin = margin;
  }

  base::MemoryMeter memory;
  engine::SortedTile<dim> tile;
  engine::CrossLevelRuns<dim> cross_level;
  engine::TileGrid<dim> grid;
  engine::TileFrame<dim> frame{grid, {}, {}, 1.0, 0.0, 0.0};
  Spheres<dim> spheres;
  std::vector<engine::Record<dim>> records;
  std::vector<float> radii;
};

TYPED_TEST_SUITE(CrossLevelRunsOf, Dimensions);

/// Every own element within reach is in a run, none twice, no copy in any.
TYPED_TEST(CrossLevelRunsOf, RunsHoldAllThatIsWithinReach) {
  Random random(12);
  std::size_t within = 0;
  std::size_t offered = 0;
  for (int k = 0; k < 400; ++k) {
    exact::Sphere<TypeParam::value> coarse{};
    coarse.radius = std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.below(40)) - 8);
    double square = 0.0;
    std::array<double, TypeParam::value> direction{};
    for (double& d : direction) {
      d = random.gaussian();
      square += d * d;
    }
    // Its surface passes through the tile.
    for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
      coarse.center[axis] =
          5.0 + 0.9 * random.uniform() + coarse.radius * direction[axis] / std::sqrt(square);
    }
    std::vector<int> in_runs(this->spheres.size());
    const kernels::TileView& view = this->tile.view();
    for (const kernels::Run& run : this->cross_level.runs(view, this->frame, just(coarse), 0)) {
      ASSERT_LT(run.begin, run.end);
      for (std::uint32_t p = run.begin; p < run.end; ++p) ++in_runs[view.number[p]];
    }
    for (std::size_t e = 0; e < this->spheres.size(); ++e) {
      const bool wanted =
          e < 3000 && exact::within_reach_exactly(coarse, this->spheres[e], this->margin);
      within += wanted ? 1 : 0;
      offered += static_cast<std::size_t>(in_runs[e]);
      ASSERT_GE(in_runs[e], wanted ? 1 : 0) << "element " << e << ", coarse " << k;
      ASSERT_LE(in_runs[e], e < 3000 ? 1 : 0);
    }
  }
  EXPECT_GT(within, 10000U);
  EXPECT_LT(offered, 3 * within) << "rows far beyond the ball";
}

/// Coarse elements that just reach an element, straight along its row.
TYPED_TEST(CrossLevelRunsOf, RunsEndBehindTheLastElementWithinReach) {
  const kernels::TileView& view = this->tile.view();
  for (std::uint32_t e = 0; e < 3000; e += 10) {
    ASSERT_TRUE(this->is_on_a_face(e));
    for (const double side : {-1.0, 1.0}) {
      const auto& element = this->spheres[e];
      exact::Sphere<TypeParam::value> coarse = element;
      coarse.radius = 0.3;
      const double reach = coarse.radius + element.radius + this->margin;
      coarse.center[0] += side * (reach - 1e-9);
      ASSERT_TRUE(exact::within_reach_exactly(coarse, element, this->margin));
      bool is_in_a_run = false;
      for (const kernels::Run& run : this->cross_level.runs(view, this->frame, just(coarse), 0)) {
        for (std::uint32_t p = run.begin; p < run.end; ++p) {
          is_in_a_run = is_in_a_run || view.number[p] == e;
        }
      }
      EXPECT_TRUE(is_in_a_run) << "element " << e << ", side " << side;
    }
  }
}

TYPED_TEST(CrossLevelRunsOf, NoRunsForCoarseElementsOutOfReach) {
  exact::Sphere<TypeParam::value> coarse{};
  coarse.radius = 1.0;
  coarse.center[0] = -100.0;
  EXPECT_TRUE(this->cross_level.runs(this->tile.view(), this->frame, just(coarse), 0).empty());
  coarse.radius = 0x1p700;
  coarse.center[0] = -0x1p702;
  coarse.center[1] = -0x1p702;
  EXPECT_TRUE(engine::coarse_element_in(this->frame, just(coarse), 0) == std::nullopt);
}

TYPED_TEST(CrossLevelRunsOf, ACoarseElementInSinglePrecisionKnowsItsError) {
  exact::Sphere<TypeParam::value> coarse{};
  coarse.radius = 300.0;
  coarse.center[0] = -295.0;
  const std::vector several(8, coarse);
  const auto near = engine::coarse_element_in<TypeParam::value>(this->frame, {several, {}}, 7);
  ASSERT_TRUE(near.has_value());
  EXPECT_EQ(near->number, 7U);
  EXPECT_EQ(near->size[0], 300.0f);
  EXPECT_NEAR(near->center[0], -300.0f, 1e-4f);
  EXPECT_GE(near->slack, 300.0f * 0x1p-20f);
  coarse.radius = 3000.0;
  EXPECT_FALSE(engine::coarse_element_in(this->frame, just(coarse), 0).has_value());
}

}  // namespace
}  // namespace abut::testing
