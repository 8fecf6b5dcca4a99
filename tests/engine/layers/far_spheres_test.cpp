// Far elements, from layer to layer: those whose own reach meets a layer, from any number of
// workers and from any first layer in the same order.

#include "engine/layers/far_spheres.hpp"

#include "base/memory_meter.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "engine/random_spheres.hpp"
#include "support/nobody_asked.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

template <class Dimension>
class FarSpheresOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using Grid = engine::LayerGrid<its_dim>;

  void SetUp() override {
    spheres_ = uniform_spheres<its_dim>(random_, 5000, {40.0, 41.0, 42.0});
    for (auto& sphere : spheres_) sphere.radius = std::exp2(random_.uniform(-3.0, 3.0));
  }

  [[nodiscard]] Grid grid() const {
    return Grid::of_cells(bounds_of<its_dim>(spheres_), 0.1, 1.5, spheres_.size()).value();
  }

  void sort(engine::FarSpheres<its_dim>& far, std::size_t workers) {
    const Grid layers = grid();
    const engine::LayerSpheres<its_dim> all(
        kernels::SphereParts(kernels::strided_spheres<its_dim>(spheres_)));
    far.start(workers);
    for (std::size_t w = 0; w < workers; ++w) {
      const std::size_t begin = spheres_.size() * w / workers;
      const std::size_t end = spheres_.size() * (w + 1) / workers;
      const std::size_t middle = (begin + end) / 2;
      far.note(all, layers, begin, middle, w);
      far.note(all, layers, middle, end, w);
    }
    NobodyAsked nobody;
    far.sort(layers, nobody.work);
  }

  static std::vector<std::uint32_t> numbers(std::span<const kernels::FarSphere> far) {
    std::vector<std::uint32_t> all;
    for (const auto& one : far) all.push_back(one.number);
    return all;
  }

  Random random_{static_cast<std::uint64_t>(201 + its_dim)};
  Spheres<its_dim> spheres_;
  base::MemoryMeter memory_;
};

TYPED_TEST_SUITE(FarSpheresOf, Dimensions);

TYPED_TEST(FarSpheresOf, ALayerHasThoseWhoseReachMeetsIt) {
  constexpr int dim = TypeParam::value;
  const auto grid = this->grid();
  engine::FarSpheres<dim> far(this->memory_);
  this->sort(far, 1);
  engine::FarSpheresInReach<dim> in_reach(this->memory_);
  const std::size_t axis = static_cast<std::size_t>(grid.map().layer_axis);
  const double lower = grid.map().lower[axis];
  const double layer_width = std::ldexp(1.0, grid.map().layer_shift) / grid.map().units_of_one;
  std::size_t found = 0;
  for (std::uint32_t k = 0; k < grid.layer_count(); ++k) {
    in_reach.start(far, k);
    const auto listed = this->numbers(in_reach.elements());
    found += listed.size();
    for (std::uint32_t n = 0; n < this->spheres_.size(); ++n) {
      const auto& sphere = this->spheres_[n];
      const double own_reach = 2.0 * sphere.radius + 0.1;
      const double begin = lower + layer_width * k;
      const bool meets = sphere.center[axis] + own_reach >= begin &&
                         sphere.center[axis] - own_reach <= begin + layer_width;
      if (!meets || !grid.is_far(grid.units_of(sphere.radius))) continue;
      EXPECT_TRUE(std::ranges::find(listed, n) != listed.end()) << "element " << n;
    }
  }
  EXPECT_GT(found, 1000U);
}

TYPED_TEST(FarSpheresOf, TheOrderDependsOnNeitherWorkersNorTheFirstLayer) {
  constexpr int dim = TypeParam::value;
  engine::FarSpheres<dim> far(this->memory_);
  this->sort(far, 1);
  engine::FarSpheresInReach<dim> advanced(this->memory_);
  advanced.start(far, 0);
  for (std::uint32_t k = 0; k < this->grid().layer_count(); ++k) {
    if (k > 0) advanced.advance(far, k);
    engine::FarSpheresInReach<dim> started(this->memory_);
    started.start(far, k);
    EXPECT_EQ(this->numbers(advanced.elements()), this->numbers(started.elements()));
    for (const std::size_t workers : {2U, 3U, 7U}) {
      engine::FarSpheres<dim> others(this->memory_);
      this->sort(others, workers);
      EXPECT_EQ(this->numbers(far.from(k)), this->numbers(others.from(k)));
      EXPECT_EQ(far.most_in_reach(), others.most_in_reach());
    }
  }
}

/// So few that one worker sorts them all.
TYPED_TEST(FarSpheresOf, AFewOfManyWorkers) {
  constexpr int dim = TypeParam::value;
  for (std::size_t k = 0; k < this->spheres_.size(); ++k) {
    if (k % 100 != 0) this->spheres_[k].radius = 0.01;
  }
  engine::FarSpheres<dim> far(this->memory_);
  this->sort(far, 1);
  engine::FarSpheres<dim> others(this->memory_);
  this->sort(others, 7);
  std::size_t found = 0;
  for (std::uint32_t k = 0; k < this->grid().layer_count(); ++k) {
    EXPECT_EQ(this->numbers(far.from(k)), this->numbers(others.from(k)));
    found += far.from(k).size();
  }
  EXPECT_GT(found, 10U);
  EXPECT_EQ(far.most_in_reach(), others.most_in_reach());
}

TYPED_TEST(FarSpheresOf, NoneWhereAllAreSmall) {
  constexpr int dim = TypeParam::value;
  for (auto& sphere : this->spheres_) sphere.radius *= 0.01;
  engine::FarSpheres<dim> far(this->memory_);
  this->sort(far, 2);
  engine::FarSpheresInReach<dim> in_reach(this->memory_);
  for (std::uint32_t k = 0; k < this->grid().layer_count(); ++k) {
    in_reach.start(far, k);
    EXPECT_TRUE(in_reach.elements().empty());
  }
}

}  // namespace
}  // namespace abut::testing
