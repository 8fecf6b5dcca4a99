// Spheres of all sizes, each of which looks for smaller ones: the pairs of a direct check, the same
// bytes from every level and number of workers, however little that pays.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

template <int Dim>
void expect_right_by_size(const Spheres<Dim>& spheres, double margin = 0.0, Way way = Way::layers) {
  expect_right_in_layers<Dim>(spheres, margin, way, always_by_size);
}

template <class Dimension>
class LayerSizesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  Random random_{static_cast<std::uint64_t>(171 + its_dim)};

  /// Radii from 1 to `ratio`, each octave as often, in a box that they fill to that part.
  Spheres<its_dim> log_uniform(std::size_t count, double ratio, double filling,
                               const std::array<double, 3>& ratios = {1.0, 1.0, 1.0}) {
    std::vector<double> radii(count);
    double volume = 0.0;
    for (double& radius : radii) {
      radius = std::exp2(random_.uniform(0.0, std::log2(ratio)));
      volume += (its_dim == 2 ? 3.14159 : 4.18879) * std::pow(radius, its_dim);
    }
    double shape = ratios[0] * ratios[1];
    if (its_dim == 3) shape *= ratios[2];
    const double side = std::pow(volume / filling / shape, 1.0 / its_dim);
    auto spheres = uniform_spheres<its_dim>(random_, count,
                                            {side * ratios[0], side * ratios[1], side * ratios[2]});
    for (std::size_t k = 0; k < count; ++k) spheres[k].radius = radii[k];
    return spheres;
  }

  /// Expects layers from as many elements on as that limit says.
  static void expect_layers_from(std::size_t engine::LayerLimits::*least,
                                 engine::LayerLimits limits, const Spheres<its_dim>& spheres) {
    limits.*least = spheres.size();
    EXPECT_TRUE((run_rows<its_dim>(spheres, {0.0, 1, Simd::scalar, limits}).in_layers));
    limits.*least = spheres.size() + 1;
    EXPECT_FALSE((run_rows<its_dim>(spheres, {0.0, 1, Simd::scalar, limits}).in_layers));
  }

  static void scale(Spheres<its_dim>& spheres, double factor) {
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x *= factor;
      sphere.radius *= factor;
    }
  }
};

TYPED_TEST_SUITE(LayerSizesOf, Dimensions);

TYPED_TEST(LayerSizesOf, FewElements) {
  for (const std::size_t count : {2U, 3U, 5U, 17U, 64U, 65U, 130U, 300U}) {
    for (const double filling : {0.02, 0.3, 2.0}) {
      SCOPED_TRACE(std::to_string(count) + " elements, filling " + std::to_string(filling));
      expect_right_by_size<TypeParam::value>(this->log_uniform(count, 8.0, filling));
    }
  }
}

TYPED_TEST(LayerSizesOf, RatiosFromNearlyEqualToHuge) {
  for (const double ratio : {1.0000001, 1.3, 4.0, 60.0, 1e3, 1e6, 1e12}) {
    for (const double filling : {0.1, 0.6}) {
      SCOPED_TRACE("ratio " + std::to_string(ratio) + ", filling " + std::to_string(filling));
      expect_right_by_size<TypeParam::value>(this->log_uniform(2500, ratio, filling));
    }
  }
}

/// Several strips in 2D, layers with many near elements in 3D: whole batches and their ends.
TYPED_TEST(LayerSizesOf, ManyElements) {
  expect_right_by_size<TypeParam::value>(this->log_uniform(20000, 30.0, 0.3));
}

/// As many of each as there may be: of two equal ones the one with the higher number finds the
/// pair.
TYPED_TEST(LayerSizesOf, EqualRadiiBesideLargerOnes) {
  constexpr int dim = TypeParam::value;
  for (const double large : {1.0, 2.0, 3.0, 10.0, 40.0}) {
    SCOPED_TRACE("large ones " + std::to_string(large));
    auto spheres = uniform_spheres<dim>(this->random_, 4000, box_for<dim>(4000, 0.8));
    for (std::size_t k = 0; k < spheres.size(); k += large < 5.0 ? 3 : 150) {
      spheres[k].radius = large;
    }
    expect_right_by_size<dim>(spheres);
    expect_right_by_size<dim>(spheres, 0.1);
  }
}

TYPED_TEST(LayerSizesOf, BoxesOfAllShapes) {
  for (const auto& ratios : box_shapes(100.0)) {
    SCOPED_TRACE(std::to_string(ratios[0]) + " : " + std::to_string(ratios[1]));
    expect_right_by_size<TypeParam::value>(this->log_uniform(2000, 20.0, 0.3, ratios));
  }
}

/// From nearly nothing to more than all radii.
TYPED_TEST(LayerSizesOf, Margins) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->log_uniform(1500, 50.0, 0.05);
  for (const double margin : {1e-12, 0.5, 5.0, 100.0}) {
    SCOPED_TRACE("margin " + std::to_string(margin));
    expect_right_by_size<dim>(spheres, margin);
  }
}

/// One that all others lie in, one that reaches far beyond the box, and one whose radius in units
/// has no square in single precision, which is left to tiles.
TYPED_TEST(LayerSizesOf, Giants) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->log_uniform(2000, 10.0, 0.1);
  for (const double radius : {50.0, 1e4, 1e9, 1e12}) {
    SCOPED_TRACE("radius " + std::to_string(radius));
    spheres[1234].radius = radius;
    expect_right_by_size<dim>(spheres);
  }
  spheres[1234].radius = 1e40;
  expect_right_by_size<dim>(spheres, 0.0, Way::tiles);
}

/// A row of small ones, and some on the surface of a giant a thousand cells away from its center,
/// nearer to touching it than single precision tells.
TYPED_TEST(LayerSizesOf, SmallOnesThatTouchAGiant) {
  constexpr int dim = TypeParam::value;
  const double large = 1000.123;
  auto spheres = uniform_spheres<dim>(this->random_, 4000, {2000.0, 0.5, 0.5});
  for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.1, 0.2);
  spheres.front() = sphere_at<dim>({0.0, 0.0, 0.0}, large);
  for (std::size_t k = 1; k < 400; ++k) {
    const double off = std::exp2(this->random_.uniform(-32.0, -20.0));
    const double reach = large + spheres[k].radius;
    const double distance = reach * (k % 2 == 0 ? 1.0 + off : 1.0 - off);
    spheres[k] = sphere_at<dim>({distance, 0.0, 0.0}, spheres[k].radius);
  }
  expect_right_by_size<dim>(spheres);
}

/// No radius at all, written in both ways, beside others.
TYPED_TEST(LayerSizesOf, PointsAmongSpheres) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->log_uniform(2000, 10.0, 0.2);
  for (std::size_t k = 0; k < spheres.size(); k += 2) spheres[k].radius = k % 4 == 0 ? 0.0 : -0.0;
  auto again = spheres;
  append<dim>(again, spheres);
  expect_right_by_size<dim>(shuffled<dim>(again, this->random_));
  expect_right_by_size<dim>(spheres, 0.25);
}

/// Two sizes that touch: large ones on a lattice, small ones in its gaps.
TYPED_TEST(LayerSizesOf, TouchingLatticesOfTwoSizes) {
  constexpr int dim = TypeParam::value;
  auto spheres = cubic_lattice<dim>(dim == 2 ? 40 : 11);
  const std::size_t large = spheres.size();
  append<dim>(spheres, spheres);
  for (std::size_t k = large; k < spheres.size(); ++k) {
    for (double& x : spheres[k].center) x += half;
    // 1/2 + 1/4 is the distance along the axis that is moved back.
    spheres[k].center[0] -= half;
    if (dim == 3) spheres[k].center[1] -= half;
    spheres[k].center[dim - 1] += 0.25;
    spheres[k].radius = 0.25;
  }
  expect_right_by_size<dim>(spheres);
  expect_right_by_size<dim>(shuffled<dim>(spheres, this->random_));
  for (auto& sphere : spheres) sphere.radius *= sphere.radius == half ? 1.5 : 4.0;
  expect_right_by_size<dim>(spheres);
}

/// Own reaches, and positions, within a few units of half a cell and of a cell: an element is near
/// or not, and looks into the next row or not.
TYPED_TEST(LayerSizesOf, OwnReachesAtTheBorders) {
  constexpr int dim = TypeParam::value;
  auto spheres = this->log_uniform(3000, 3.0, 0.4);
  const grid::Bounds<dim> bounds = bounds_of<dim>(spheres);
  // The grid that the search will choose is not known here: a ladder of radii meets its borders.
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const double step = std::exp2(-static_cast<double>(k % 24));
    spheres[k].radius = bounds.largest_radius * (k % 2 == 0 ? 0.5 + step : 1.0 / (1.0 + step));
  }
  expect_right_by_size<dim>(spheres);
}

/// Runs that are longer than vectors, and the same place many times.
TYPED_TEST(LayerSizesOf, Crowds) {
  constexpr int dim = TypeParam::value;
  for (const double spread : {0.0, 0.4, 3.0}) {
    SCOPED_TRACE("spread " + std::to_string(spread));
    auto spheres = clumps<dim>(this->random_, 1200, 120, {60.0, 60.0, 60.0}, spread);
    for (auto& sphere : spheres) sphere.radius = 0.05 * std::exp2(this->random_.uniform(0.0, 5.0));
    expect_right_by_size<dim>(spheres);
  }
}

/// Elements in and beside a crowd: of the adjacent rows in which one looks, some hold many vectors
/// of smaller ones, and some a few elements.
TYPED_TEST(LayerSizesOf, LargerOnesBesideACrowd) {
  constexpr int dim = TypeParam::value;
  auto spheres = uniform_spheres<dim>(this->random_, 3000, {30.0, 30.0, 30.0});
  for (const auto& sphere : uniform_spheres<dim>(this->random_, 1500, {4.0, 4.0, 4.0})) {
    spheres.push_back(sphere);
  }
  for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.01, 0.02);
  for (auto sphere : uniform_spheres<dim>(this->random_, 1500, {8.0, 8.0, 8.0})) {
    sphere.radius = this->random_.uniform(0.3, 1.2);
    spheres.push_back(sphere);
  }
  expect_right_by_size<dim>(spheres);
}

TYPED_TEST(LayerSizesOf, NumbersOfAnySize) {
  constexpr int dim = TypeParam::value;
  for (const double factor : {0x1p-1060, 0x1p-900, 0x1p-500, 0x1p500, 0x1p900, 0x1p1000}) {
    SCOPED_TRACE("factor " + std::to_string(factor));
    auto spheres = this->log_uniform(800, 100.0, 0.3);
    this->scale(spheres, factor);
    expect_right_by_size<dim>(spheres);
    expect_right_by_size<dim>(spheres, 2.0 * factor);
  }
}

TYPED_TEST(LayerSizesOf, FarFromTheOriginAndFarStrays) {
  constexpr int dim = TypeParam::value;
  for (const double offset : {0x1p40, -0x1p49}) {
    SCOPED_TRACE("offset " + std::to_string(offset));
    auto spheres = this->log_uniform(1000, 20.0, 0.3);
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x += offset;
    }
    expect_right_by_size<dim>(spheres);
  }
  for (const double distance : {1e4, 1e9, 1e300}) {
    SCOPED_TRACE("stray at " + std::to_string(distance));
    auto spheres = this->log_uniform(300, 20.0, 0.3);
    spheres.front().center[0] = distance;
    expect_right_by_size<dim>(spheres);
  }
}

/// What may be found depends on sizes alone: an element without smaller ones around it makes no
/// tests but of itself.
TYPED_TEST(LayerSizesOf, TestsFollowTheSmallerOnes) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->log_uniform(dim == 2 ? 20000 : 30000, 1000.0, 0.3);
  const LayerRun by_size = run_rows<dim>(spheres, {0.0, 1, Simd::scalar, always_by_size});
  ASSERT_TRUE(by_size.in_layers);
  EXPECT_LT(by_size.candidate_tests, 25 * spheres.size());
}

/// Radii from 1 to 100, for which tiles and layers cost nearly the same: layers are taken from so
/// many elements on that the copies that tiles take cost more.
TYPED_TEST(LayerSizesOf, CopiesOfTilesCostMoreThanTests) {
  this->expect_layers_from(&engine::LayerLimits::least_elements_of_copies,
                           {.most_joined = 0.0, .cost_of_copies = 1000.0},
                           this->log_uniform(20000, 100.0, 0.3));
}

/// Radii from 1 to 30 and to 100 make crowds in layers of one reach. The smaller ones are searched
/// in these, the others by size, or where copies of tiles are in the caches, in tiles: the work of
/// each tells where it was done.
TYPED_TEST(LayerSizesOf, MixturesAreSearchedWhereTheyCostLeast) {
  constexpr int dim = TypeParam::value;
  const auto run = [&](std::size_t count, double ratio) {
    return run_rows<dim>(this->log_uniform(count, ratio, 0.3), {0.0, 2, Simd::scalar});
  };
  if (dim == 2) {
    // Few elements are in reach whatever their sizes.
    EXPECT_TRUE(run(40000, 100.0).in_layers);
    return;
  }
  const LayerRun in_blocks = run(60000, 30.0);
  EXPECT_TRUE(in_blocks.in_layers);
  EXPECT_GT(in_blocks.candidate_tests, 60000U * 40);
  const LayerRun by_size = run(60000, 100.0);
  EXPECT_TRUE(by_size.in_layers);
  EXPECT_LT(by_size.candidate_tests, 60000U * 20);
  EXPECT_FALSE(run(10000, 30.0).in_layers);
  EXPECT_FALSE(run(10000, 100.0).in_layers);
}

/// Nearly equal radii go to layers of one reach, in which elements are tested against each other
/// once, whatever copies cost.
TYPED_TEST(LayerSizesOf, CopiesOfTilesDoNotWeighAgainstLayers) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->log_uniform(20000, 1.2, 0.3);
  const engine::LayerLimits limits{.cost_of_copies = 1000.0, .least_elements_of_copies = 0};
  const engine::LayerLimits without{.cost_of_copies = 0.0, .least_elements_of_copies = 0};
  const LayerRun run = run_rows<dim>(spheres, {0.0, 1, Simd::scalar, limits});
  EXPECT_TRUE(run.in_layers);
  expect_same(run, run_rows<dim>(spheres, {0.0, 1, Simd::scalar, without}));
}

/// Nobody asks how many there are of each radius where all are nearly equal.
TYPED_TEST(LayerSizesOf, RadiiAlikeAreNotSearchedBySize) {
  constexpr int dim = TypeParam::value;
  engine::LayerLimits limits = always_by_size;
  limits.radii_alike = engine::LayerLimits{}.radii_alike;
  const auto is_by_size = [&](double ratio) {
    auto spheres = this->log_uniform(2000, ratio, 0.3);
    // The extremes themselves.
    const auto [smallest, largest] =
        std::ranges::minmax_element(spheres, {}, [](const auto& sphere) { return sphere.radius; });
    smallest->radius = 1.0;
    largest->radius = ratio;
    return run_rows<dim>(spheres, {0.0, 1, Simd::scalar, limits}).in_layers;
  };
  EXPECT_FALSE(is_by_size(1.125));
  EXPECT_TRUE(is_by_size(std::nextafter(1.125, 2.0)));
}

/// All workers count radii, from some number of elements on; what is chosen does not depend on how
/// many of them there are.
TYPED_TEST(LayerSizesOf, RadiiOfManyAreCountedByAllWorkers) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->log_uniform(40000, dim == 2 ? 100.0 : 1000.0, 0.3);
  const LayerRun first = run_rows<dim>(spheres, {0.0, 1, Simd::scalar});
  EXPECT_TRUE(first.in_layers);
  for (const std::size_t workers : {2U, 3U, 7U}) {
    SCOPED_TRACE(std::to_string(workers) + " workers");
    expect_same(first, run_rows<dim>(spheres, {0.0, workers, Simd::scalar}));
  }
}

/// The same where cells are as narrow as the reach allows.
TYPED_TEST(LayerSizesOf, FewElementsOfNarrowCells) {
  constexpr int dim = TypeParam::value;
  engine::LayerLimits limits{.least_elements_of_tiles = 1'500'000, .most_by_size = 0.0};
  this->expect_layers_from(&engine::LayerLimits::least_elements_of_dense, limits,
                           this->log_uniform(3000, 1.1, 0.6));
  const auto sparse = this->log_uniform(3000, 1.1, dim == 2 ? 0.1 : 0.03);
  limits.least_elements_of_dense = 0;
  EXPECT_FALSE((run_rows<dim>(sparse, {0.0, 1, Simd::scalar, limits}).in_layers));
}

/// Where elements crowd, fewer of them are searched in layers than otherwise.
TYPED_TEST(LayerSizesOf, FewElementsOfCrowds) {
  constexpr int dim = TypeParam::value;
  const auto spheres = this->log_uniform(2000, 1.1, dim == 2 ? 20.0 : 8.0);
  engine::LayerLimits limits{.least_elements_of_tiles = 1'500'000,
                             .least_elements_of_dense = 1'500'000,
                             .most_by_size = 0.0};
  this->expect_layers_from(&engine::LayerLimits::least_elements_of_crowds, limits, spheres);
  limits.least_joined_of_crowds = std::numeric_limits<double>::infinity();
  EXPECT_FALSE((run_rows<dim>(spheres, {0.0, 1, Simd::scalar, limits}).in_layers));
}

}  // namespace
}  // namespace abut::testing
