// Rods and plates with thousands of cells along an axis, where a cell has fewer units: each of
// 2^19 to 2^16 to a cell, with pairs at the very reach, on exact lattices, of boxes, and beyond.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::testing {
namespace {

/// Cells along the longest axis: each number has a unit of its own, 2^19, 2^18, 2^17 and 2^16 to a
/// cell.
constexpr std::array<double, 4> lengths{3000.0, 7000.0, 15000.0, 31000.0};

/// Cells are not widened where there are no more than three for each element.
constexpr double cells_of_element = 2.7;

constexpr std::size_t elements_for(double length) {
  return static_cast<std::size_t>(length / cells_of_element);
}

template <class Dimension>
class LayerLongAxesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  /// A rod that long in its turn along each axis, less than a cell thick.
  std::array<double, 3> rod(double length) {
    std::array<double, 3> extent{0.7, 0.6, 0.5};
    extent[turn_++ % its_dim] = length;
    return extent;
  }

  /// Bits of the units of a cell of a system of reach 1.
  static int bits_of_units(const Spheres<its_dim>& spheres) {
    const auto grid =
        engine::LayerGrid<its_dim>::over(bounds_of<its_dim>(spheres), 0.0, 1.001, spheres.size());
    return grid ? grid->cell_shift() : 0;
  }

  Random random_{static_cast<std::uint64_t>(131 + its_dim)};

 private:
  std::size_t turn_ = 0;
};

TYPED_TEST_SUITE(LayerLongAxesOf, Dimensions);

TYPED_TEST(LayerLongAxesOf, RodsOfManyLengths) {
  constexpr int dim = TypeParam::value;
  int bits = 19;
  for (const double length : lengths) {
    SCOPED_TRACE(length);
    auto spheres = uniform_spheres<dim>(this->random_, elements_for(length), this->rod(length));
    EXPECT_EQ(this->bits_of_units(spheres), bits--);
    expect_right_in_layers<dim>(spheres);
    for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.1, half);
    expect_right_in_layers<dim>(spheres, 0.01);
  }
}

/// Neighbours touch, or fail to by a last place: a coarse unit leaves all of them undecided.
TYPED_TEST(LayerLongAxesOf, PairsAtTheReach) {
  constexpr int dim = TypeParam::value;
  for (const double length : lengths) {
    SCOPED_TRACE(length);
    Spheres<dim> spheres;
    for (std::size_t k = 0; k < elements_for(length); ++k) {
      // Three in a row touch, then there is a gap.
      const double x = 0.1 * static_cast<double>(8 * (k / 3) + k % 3);
      spheres.push_back(sphere_at<dim>({beside(this->random_, x), 0.1, 0.1}, 0.05));
    }
    expect_right_in_layers<dim>(spheres);
    const engine::RowsSettings settings{0.0, 1, Simd::scalar, always_in_layers};
    EXPECT_GT(run_rows<dim>(spheres, settings).exact_decisions, 0U);
  }
}

/// Distances are exact along axes of any length that layers have.
TYPED_TEST(LayerLongAxesOf, DistancesAreExact) {
  constexpr int dim = TypeParam::value;
  for (const double length : lengths) {
    SCOPED_TRACE(length);
    // Two beside two touch, then there is a gap.
    Spheres<dim> spheres;
    for (const std::size_t row : {0U, 1U}) {
      for (std::size_t k = 0; k < elements_for(length) / 2; ++k) {
        const double x = 10.0 * static_cast<double>(k / 2) + static_cast<double>(k % 2);
        spheres.push_back(sphere_at<dim>({static_cast<double>(row), x, 0.0}));
      }
    }
    expect_right_in_layers<dim>(spheres);
    const engine::RowsSettings settings{0.0, 1, Simd::scalar, always_in_layers};
    EXPECT_EQ(run_rows<dim>(spheres, settings).exact_decisions, 0U);
    spheres.back().center[0] += 0x1p-40;
    expect_right_in_layers<dim>(spheres);
  }
}

TYPED_TEST(LayerLongAxesOf, Boxes) {
  constexpr int dim = TypeParam::value;
  for (const double length : lengths) {
    SCOPED_TRACE(length);
    auto boxes = uniform_boxes<dim>(this->random_, elements_for(length), this->rod(length));
    boxes.push_back(box_at<dim>({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}));
    expect_right_in_layers<dim>(boxes);
  }
}

/// More cells than positions have bits for: these elements are searched in tiles.
TYPED_TEST(LayerLongAxesOf, LongerOnesThanLayersHave) {
  constexpr int dim = TypeParam::value;
  constexpr double length = 33000.0;
  const auto spheres = uniform_spheres<dim>(this->random_, elements_for(length), this->rod(length));
  expect_right_in_layers<dim>(spheres, 0.0, Way::tiles);
}

/// A plate whose layers are long in turn along each axis.
TYPED_TEST(LayerLongAxesOf, Plates) {
  constexpr int dim = TypeParam::value;
  std::array<double, 3> extent{3000.0, 60.0, 0.5};
  if (dim == 2) extent = {60.0, 3000.0, 0.0};
  const Simd level = simd_levels_here().back();
  for (int turn = 0; turn < dim; ++turn) {
    const auto plate = uniform_spheres<dim>(this->random_, 70000, extent);
    EXPECT_EQ(this->bits_of_units(plate), 19);
    const LayerRun run = run_rows<dim>(plate, {0.0, 2, level, always_in_layers});
    EXPECT_TRUE(run.in_layers);
    EXPECT_TRUE(same_pairs(directly_checked<dim>(plate, 0.0), run.pairs));
    std::rotate(extent.begin(), extent.begin() + 1, extent.begin() + dim);
  }
}

}  // namespace
}  // namespace abut::testing
