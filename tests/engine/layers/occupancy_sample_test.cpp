#include "engine/layers/occupancy_sample.hpp"

#include "base/memory_meter.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "engine/random_spheres.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::testing {
namespace {

template <class Dimension>
class OccupancySampleOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  /// Cells along each axis; there are about 30,000.
  static constexpr std::size_t side = its_dim == 2 ? 172 : 31;

  /// In cells of size 1.
  double mean_occupancy(const Spheres<its_dim>& spheres,
                        engine::SampleSize size = engine::SampleSize::full) {
    sample_.take_from(in_layers(spheres), 1);
    return sample_.mean_occupancy(grid_over(spheres), size);
  }

  static engine::LayerGrid<its_dim> grid_over(const Spheres<its_dim>& spheres) {
    return layer_grid_over<its_dim>(bounds_of<its_dim>(spheres), 1.0, 1.0, spheres.size()).value();
  }
  static engine::LayerSpheres<its_dim> in_layers(const Spheres<its_dim>& spheres) {
    return engine::LayerSpheres<its_dim>(
        kernels::SphereParts(kernels::strided_spheres<its_dim>(spheres)));
  }

  base::MemoryMeter memory_;
  engine::OccupancySample<its_dim> sample_{memory_};
  Random random_{static_cast<std::uint64_t>(71 + its_dim)};
};

TYPED_TEST_SUITE(OccupancySampleOf, Dimensions);

/// Poisson numbers with mean m have a mean occupancy of m + 1. The estimate is off by a fifth at
/// most, twice its own standard deviation.
TYPED_TEST(OccupancySampleOf, RandomElements) {
  constexpr int dim = TypeParam::value;
  const auto width = static_cast<double>(TestFixture::side);
  const std::size_t cells = dim == 2 ? 172 * 172 : 31 * 31 * 31;
  for (const double in_cell : {1.0, 3.0, 10.0}) {
    const auto count = static_cast<std::size_t>(in_cell * static_cast<double>(cells));
    const auto spheres = uniform_spheres<dim>(this->random_, count, {width, width, width});
    EXPECT_NEAR(this->mean_occupancy(spheres) / (in_cell + 1.0), 1.0, 0.25) << in_cell;
  }
}

TYPED_TEST(OccupancySampleOf, OneInEachCell) {
  EXPECT_NEAR(this->mean_occupancy(cubic_lattice<TypeParam::value>(TestFixture::side)), 1.0, 0.4);
}

TYPED_TEST(OccupancySampleOf, ClustersAreManyTimesAsCrowded) {
  constexpr int dim = TypeParam::value;
  const auto width = static_cast<double>(TestFixture::side);
  const auto spheres = clumps<dim>(this->random_, 30000, 200, {width, width, width}, 0.1);
  EXPECT_GT(this->mean_occupancy(spheres), 60.0);
}

/// A small sample tells clusters from elements spread at random, which have 2.
TYPED_TEST(OccupancySampleOf, ASmallOneTellsClusters) {
  constexpr int dim = TypeParam::value;
  const double width = dim == 2 ? 100.0 : 21.5;
  for (int round = 0; round < 20; ++round) {
    const auto spread = uniform_spheres<dim>(this->random_, 10000, {width, width, width});
    EXPECT_LT(this->mean_occupancy(spread, engine::SampleSize::small), 6.0);
    const auto clustered = clumps<dim>(this->random_, 10000, 30, {width, width, width}, 0.1);
    EXPECT_GT(this->mean_occupancy(clustered, engine::SampleSize::small), 6.0);
  }
}

/// One crowd among many that are no crowd.
TYPED_TEST(OccupancySampleOf, ACrowdOfATenth) {
  constexpr int dim = TypeParam::value;
  const auto width = static_cast<double>(TestFixture::side);
  auto spheres = uniform_spheres<dim>(this->random_, 27000, {width, width, width});
  append<dim>(spheres, Spheres<dim>(3000, sphere_at<dim>({9.5, 9.5, 9.5})));
  EXPECT_GT(this->mean_occupancy(spheres), 100.0);
}

TYPED_TEST(OccupancySampleOf, IsTheSameEachTime) {
  constexpr int dim = TypeParam::value;
  const auto spheres = uniform_spheres<dim>(this->random_, 5000, {20.0, 21.0, 22.0});
  const double first = this->mean_occupancy(spheres);
  // A sample of another size between the two.
  static_cast<void>(
      this->mean_occupancy(uniform_spheres<dim>(this->random_, 9000, {9.0, 9.0, 9.0})));
  EXPECT_EQ(this->mean_occupancy(spheres), first);
  for (const std::size_t workers : {1U, 2U, 7U}) {
    engine::OccupancySample<dim> other(this->memory_);
    other.take_from(this->in_layers(spheres), workers);
    // A full sample begins with the draws of a small one, which it keeps.
    const double small = other.mean_occupancy(this->grid_over(spheres), engine::SampleSize::small);
    EXPECT_EQ(other.mean_occupancy(this->grid_over(spheres), engine::SampleSize::full), first);
    EXPECT_EQ(other.mean_occupancy(this->grid_over(spheres), engine::SampleSize::small), small);
  }
}

/// The second kind of cells is asked about after the elements were overwritten.
TYPED_TEST(OccupancySampleOf, DrawsOnce) {
  constexpr int dim = TypeParam::value;
  auto spheres = uniform_spheres<dim>(this->random_, 5000, {20.0, 21.0, 22.0});
  const auto grid = this->grid_over(spheres);
  const double first = this->mean_occupancy(spheres);
  std::ranges::fill(spheres, sphere_at<dim>({1.0, 2.0, 3.0}));
  EXPECT_EQ(this->sample_.mean_occupancy(grid, engine::SampleSize::full), first);
  EXPECT_EQ(this->mean_occupancy(spheres), 5000.0);
}

TYPED_TEST(OccupancySampleOf, FewElements) {
  constexpr int dim = TypeParam::value;
  EXPECT_EQ(this->mean_occupancy(Spheres<dim>(1, sphere_at<dim>({1.0, 2.0, 3.0}))), 1.0);
  EXPECT_EQ(this->mean_occupancy(Spheres<dim>(40, sphere_at<dim>({1.0, 2.0, 3.0}))), 40.0);
}

}  // namespace
}  // namespace abut::testing
