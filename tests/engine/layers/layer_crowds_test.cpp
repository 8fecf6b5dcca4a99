// Runs of more elements than a vector holds, next to runs of fewer, and more hits of one element
// than a buffer holds.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "kernels/search_job.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class LayerCrowdsOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  Random random_{static_cast<std::uint64_t>(51 + its_dim)};
};

TYPED_TEST_SUITE(LayerCrowdsOf, Dimensions);

/// Two runs that are joined have about eight elements: less, just as many, or more.
TYPED_TEST(LayerCrowdsOf, RunsThatJustFillAVectorOrDoNot) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t largest : {4U, 8U, 12U, 24U}) {
    SCOPED_TRACE("clumps of " + std::to_string(largest));
    const auto extent = box_for<dim>(2000, 5.0);
    expect_right_in_layers<dim>(clumps<dim>(this->random_, 2000, largest, extent, 0.0));
    expect_right_in_layers<dim>(clumps<dim>(this->random_, 2000, largest, extent, 0.4));
  }
}

TYPED_TEST(LayerCrowdsOf, AllInOnePlace) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : {8U, 9U, 10U, 17U, 300U}) {
    SCOPED_TRACE(std::to_string(count) + " elements");
    expect_right_in_layers<dim>(Spheres<dim>(count, sphere_at<dim>({3.0, 4.0, 5.0})));
  }
}

/// All runs of an element in the middle have so many elements, whose vectors are tested one after
/// the other up to 128 of them; beside them stand runs of any number.
TYPED_TEST(LayerCrowdsOf, RunsOfAsManyAsSomeVectorsHold) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : {7U, 8U, 9U, 15U, 16U, 17U, 24U, 25U, 127U, 128U, 129U}) {
    SCOPED_TRACE("runs of " + std::to_string(count));
    Spheres<dim> spheres;
    for (const auto& place : cubic_lattice<dim>(3)) {
      for (std::size_t k = 0; k < count; ++k) {
        spheres.push_back(place);
        for (double& x : spheres.back().center) x += this->random_.uniform(0.0, 0.05);
      }
    }
    append<dim>(spheres, uniform_spheres<dim>(this->random_, 300, {6.0, 5.0, 7.0}));
    expect_right_in_layers<dim>(spheres);
    for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.4, half);
    expect_right_in_layers<dim>(spheres);
  }
}

TYPED_TEST(LayerCrowdsOf, MoreHitsOfAnElementThanABufferHolds) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres(kernels::HitBuffer::size + 70, sphere_at<dim>({3.0, 3.0, 3.0}));
  append<dim>(spheres, uniform_spheres<dim>(this->random_, 300, {8.0, 8.0, 8.0}));
  expect_right_in_layers<dim>(spheres);
}

/// The same where each pair touches exactly: the buffer is full of undecided ones.
TYPED_TEST(LayerCrowdsOf, MoreUndecidedPairsThanABufferHolds) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres(kernels::HitBuffer::size / 2 + 100, sphere_at<dim>({3.0, 3.0, 3.0}));
  append<dim>(spheres,
              Spheres<dim>(kernels::HitBuffer::size / 2 + 100, sphere_at<dim>({4.0, 3.0, 3.0})));
  append<dim>(spheres, uniform_spheres<dim>(this->random_, 300, {8.0, 8.0, 8.0}));
  expect_right_in_layers<dim>(spheres);
}

/// A long run at the begin of a row: the other run that it is joined with, in the next strip,
/// begins where fewer elements stand before it. In 2D there are three strips.
TYPED_TEST(LayerCrowdsOf, LongRunsAtTheBeginOfEachRow) {
  constexpr int dim = TypeParam::value;
  const double width = dim == 2 ? 160.0 : 12.0;
  Spheres<dim> spheres =
      uniform_spheres<dim>(this->random_, 6000, {width, width + 1.0, width + 2.0});
  for (std::size_t k = 0; k < 6000; ++k) {
    auto sphere = uniform_spheres<dim>(this->random_, 1, {width, width + 1.0, width + 2.0})[0];
    sphere.center[dim - 2] = 0.01;
    spheres.push_back(sphere);
  }
  expect_right_in_layers<dim>(spheres);
}

/// Up to 19 hits in three vectors, none of which is too short: the buffer is nearly full again and
/// again when they are to be written. Four elements in each of nine places, in rows and layers that
/// hold one such place each.
TEST(LayerCrowds, ManyHitsThatNeedNoCare) {
  constexpr double farther = 4.0;
  constexpr std::array<double, 3> offsets{0.9, 1.5, 2.1};
  Spheres<3> spheres{sphere_at<3>({0.0, 0.0, 0.0}), sphere_at<3>({35.0, 40.0, 45.0})};
  for (int group = 0; group < 8 * 9 * 10; ++group) {
    const std::array<double, 3> corner{farther * (group % 8), farther * (group / 8 % 9),
                                       farther * (group / 72)};
    for (const double x : offsets) {
      for (const double z : offsets) {
        append<3>(spheres,
                  Spheres<3>(4, sphere_at<3>({corner[0] + x, corner[1] + 0.5, corner[2] + z})));
      }
    }
  }
  expect_right_in_layers<3>(spheres);
}

/// Elements whose five runs get a vector each, since two of them hold too many, in the first row of
/// a layer: there is no row before it in the next layer, and what stands in its place is the begin
/// of a row that the same elements meet.
TEST(LayerCrowds, CrowdedElementsInTheFirstRow) {
  constexpr double cell = 1.0 + 0x1p-10;
  Spheres<3> spheres{sphere_at<3>({0.0, 1.1, 0.0}), sphere_at<3>({40.0, 1.1, 60.0})};
  const auto put_row = [&](std::size_t count, double first, double step, double y, double z) {
    for (std::size_t k = 0; k < count; ++k) {
      spheres.push_back(sphere_at<3>({first + step * static_cast<double>(k), y, z}));
    }
  };
  for (std::size_t k = 0; k < 15; ++k) {
    const double z = (0.5 + 4.0 * static_cast<double>(k)) * cell;
    put_row(150, 0.0, 0.19, 0.0, z);
    put_row(100, 0.0, 0.31, 1.1, z);
    put_row(20, 26.0, 0.19, 0.0, z + 0.8);
  }
  expect_right_in_layers<3>(spheres);
}

/// As dense everywhere as elements of smoothed-particle methods are, and denser: all share blocks
/// of candidates, whose sizes end anywhere in a vector. The largest are too large for a block.
TYPED_TEST(LayerCrowdsOf, AllShareBlocks) {
  constexpr int dim = TypeParam::value;
  for (const double neighbors : {12.0, 30.0, 80.0, 250.0}) {
    SCOPED_TRACE(std::to_string(neighbors) + " neighbors");
    auto spheres = uniform_spheres<dim>(this->random_, 2000, box_for<dim>(2000, neighbors));
    expect_right_in_layers<dim>(spheres);
    for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.8 * half, half);
    expect_right_in_layers<dim>(spheres);
  }
}

/// The first block has all elements: as many as it may have, one less or one more.
TYPED_TEST(LayerCrowdsOf, LargestBlocks) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : {959U, 960U, 961U}) {
    SCOPED_TRACE(std::to_string(count) + " elements");
    expect_right_in_layers<dim>(uniform_spheres<dim>(this->random_, count, {0.6, 0.6, 0.6}));
  }
}

/// In blocks the filter leaves some pairs undecided: those that touch exactly, or nearly.
TYPED_TEST(LayerCrowdsOf, UndecidedPairsInBlocks) {
  constexpr int dim = TypeParam::value;
  auto spheres = uniform_spheres<dim>(this->random_, 2000, box_for<dim>(2000, 40.0));
  for (std::size_t k = 9; k < spheres.size(); k += 10) {
    spheres[k] = spheres[k - 1];
    spheres[k].center[k % dim] += 1.0;
  }
  expect_right_in_layers<dim>(spheres);
}

/// From thinly spread to so crowded that each element needs care, along the rows of each layer: the
/// ways in which vectors are filled follow each other.
TYPED_TEST(LayerCrowdsOf, DensitiesThatChangeAlongRows) {
  constexpr int dim = TypeParam::value;
  for (const double power : {2.0, 4.0, 8.0}) {
    auto spheres = uniform_spheres<dim>(this->random_, dim == 2 ? 9000 : 5000, {1.0, 1.0, 1.0});
    for (auto& sphere : spheres) {
      sphere.center[dim - 2] = 40.0 * std::pow(sphere.center[dim - 2], power);
      sphere.center[dim - 1] *= 50.0;
    }
    expect_right_in_layers<dim>(spheres);
    for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.35, half);
    expect_right_in_layers<dim>(spheres);
  }
}

}  // namespace
}  // namespace abut::testing
