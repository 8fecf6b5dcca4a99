// Boxes in layers, however little that pays: the pairs of a direct check, the same bytes from every
// level and number of workers.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace abut::testing {
namespace {

using Vector = std::array<double, 3>;

template <class Dimension>
class LayerBoxesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using ItsBoxes = Boxes<its_dim>;

  ItsBoxes dense(std::size_t count, const Vector& widest = {1.0, 1.0, 1.0}) {
    return uniform_boxes<its_dim>(random_, count, box_for<its_dim>(count, 6.0), widest);
  }

  /// A full grid of boxes of that width, each of which touches all around it.
  static ItsBoxes voxels(std::size_t side, double width) {
    ItsBoxes boxes;
    const std::size_t layers = its_dim == 2 ? 1 : side;
    for (std::size_t k = 0; k < side * side * layers; ++k) {
      const std::array<std::size_t, 3> at{k % side, k / side % side, k / (side * side)};
      exact::Box<its_dim> box{};
      for (std::size_t axis = 0; axis < std::size_t{its_dim}; ++axis) {
        box.lower[axis] = static_cast<double>(at[axis]) * width;
        box.upper[axis] = static_cast<double>(at[axis] + 1) * width;
      }
      boxes.push_back(box);
    }
    return boxes;
  }

  Random random_{static_cast<std::uint64_t>(91 + its_dim)};
};

TYPED_TEST_SUITE(LayerBoxesOf, Dimensions);

TYPED_TEST(LayerBoxesOf, AnyNumberAndDensity) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t count : {1U, 2U, 3U, 65U, 300U, 2500U}) {
    for (const double neighbors : {0.02, 1.0, 6.0, 60.0}) {
      SCOPED_TRACE(std::to_string(count) + " boxes, neighbors " + std::to_string(neighbors));
      expect_right_in_layers<dim>(
          uniform_boxes<dim>(this->random_, count, box_for<dim>(count, neighbors)));
    }
  }
}

/// The layer axis and the row axis on each of the axes.
TYPED_TEST(LayerBoxesOf, SystemsOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const auto& ratios : box_shapes(30.0)) {
    SCOPED_TRACE(std::to_string(ratios[0]) + " : " + std::to_string(ratios[1]));
    expect_right_in_layers<dim>(
        uniform_boxes<dim>(this->random_, 1500, box_for<dim>(1500, 6.0, ratios)));
  }
}

/// Plates and needles along each axis, and points.
TYPED_TEST(LayerBoxesOf, BoxesOfAllShapes) {
  constexpr int dim = TypeParam::value;
  for (const Vector& widest : {Vector{1.0, 0.01, 1.0},
                               {0.01, 1.0, 0.01},
                               {1.0, 1.0, 0.0},
                               {0.0, 0.0, 1.0},
                               {1.0, 0.0, 0.0},
                               {0.0, 1.0, 0.0}}) {
    SCOPED_TRACE(std::to_string(widest[0]) + " : " + std::to_string(widest[1]));
    auto boxes = this->dense(1500, widest);
    boxes.push_back(box_at<dim>({3.0, 3.0, 3.0}, {1.0, 1.0, 1.0}));  // the widest of all
    append<dim>(boxes, Boxes<dim>(20, box_at<dim>({4.0, 3.5, 3.5}, {})));
    expect_right_in_layers<dim>(boxes);
    expect_right_in_layers<dim>(boxes, 0.25);
  }
}

/// Ends that coincide, or do so but for some last places: what the filter must leave undecided.
TYPED_TEST(LayerBoxesOf, EndsThatCoincideOrNearlyDo) {
  constexpr int dim = TypeParam::value;
  for (const double margin : {0.0, 0.375}) {
    Boxes<dim> boxes;
    for (std::size_t k = 0; k < 1000; ++k) {
      exact::Box<dim> box{};
      exact::Box<dim> other{};
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
        const double width = 0.125 * static_cast<double>(this->random_.below(9));
        const double their_width = 0.125 * static_cast<double>(this->random_.below(9));
        box.lower[axis] = this->random_.uniform(0.0, dim == 2 ? 60.0 : 14.0);
        box.upper[axis] = box.lower[axis] + width;
        const bool is_ahead = this->random_.below(2) == 0;
        const double gap = this->random_.below(3) == 0 ? margin : -margin;
        const double end = is_ahead ? box.upper[axis] + gap : box.lower[axis] - gap;
        const double near = beside(this->random_, end);
        other.lower[axis] = is_ahead ? near : near - their_width;
        other.upper[axis] = is_ahead ? near + their_width : near;
      }
      boxes.push_back(box);
      boxes.push_back(other);
    }
    expect_right_in_layers<dim>(boxes, margin);
  }
}

/// Most have undecided pairs, as the cells of a mesh do.
TYPED_TEST(LayerBoxesOf, Voxels) {
  constexpr int dim = TypeParam::value;
  const std::size_t side = dim == 2 ? 50 : 13;
  for (const double width : {1.0, 0.1, 1.0 / 3.0}) {
    SCOPED_TRACE("width " + std::to_string(width));
    const auto boxes = TestFixture::voxels(side, width);
    expect_right_in_layers<dim>(boxes);
    expect_right_in_layers<dim>(boxes, width);
  }
}

/// The reach ends at a face of cells, rows or columns, on either side of an element.
TYPED_TEST(LayerBoxesOf, PairsAcrossFaces) {
  constexpr int dim = TypeParam::value;
  constexpr double reach = 1024.0 / 1025.0;
  const Vector extent = dim == 2 ? Vector{40.0, 50.0, 0.0} : Vector{9.0, 10.0, 11.0};
  Boxes<dim> boxes{box_at<dim>({0.0, 0.0, 0.0}, {reach, reach, reach}),
                   box_at<dim>(extent, {reach, reach, reach})};
  for (std::size_t k = 0; k < 1000; ++k) {
    Vector lower{};
    Vector beyond{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      const double parts = std::array{1.0, 4.0, 0x1p22}[this->random_.below(3)];
      const double x = this->random_.uniform(0.0, extent[axis] - 1.0);
      lower[axis] = beside(this->random_, std::floor(x * parts) / parts);
      beyond[axis] = beside(this->random_, lower[axis] + reach);
    }
    boxes.push_back(box_at<dim>(lower, {reach, reach, reach}));
    boxes.push_back(box_at<dim>(beyond, {0.5, 0.5, 0.5}));
  }
  expect_right_in_layers<dim>(boxes);
}

/// More candidates in one place than vectors and buffers hold, beside boxes that are alone.
TYPED_TEST(LayerBoxesOf, Crowds) {
  constexpr int dim = TypeParam::value;
  for (const std::size_t crowd : {9U, 17U, 64U, 150U}) {
    SCOPED_TRACE("crowds of " + std::to_string(crowd));
    auto boxes = this->dense(1000);
    const auto center = boxes.front();
    append<dim>(boxes, Boxes<dim>(crowd, center));
    const Vector some{1.0, 1.0, 1.0};
    append<dim>(boxes, uniform_boxes<dim>(this->random_, crowd, some));
    expect_right_in_layers<dim>(boxes);
  }
  expect_right_in_layers<dim>(Boxes<dim>(1100, this->dense(1).front()));
}

/// So wide that all elements share blocks of candidates.
TYPED_TEST(LayerBoxesOf, AllShareBlocks) {
  constexpr int dim = TypeParam::value;
  for (const double times : {1.5, 2.2, 3.0}) {
    SCOPED_TRACE(std::to_string(times) + " times as wide");
    auto boxes = this->dense(1500);
    for (auto& box : boxes) {
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
        box.upper[axis] = box.lower[axis] + times * (box.upper[axis] - box.lower[axis]);
      }
    }
    expect_right_in_layers<dim>(boxes);
  }
}

TYPED_TEST(LayerBoxesOf, ClustersAndFarStrays) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {30.0, 1e9, 0x1p60, 1e300}) {
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      SCOPED_TRACE(std::to_string(distance) + " away on axis " + std::to_string(axis));
      auto boxes = this->dense(500);
      auto stray = boxes[7];
      stray.lower[axis] += distance;
      stray.upper[axis] = stray.lower[axis] + 0.5;
      boxes.push_back(stray);
      expect_right_in_layers<dim>(boxes);
      boxes.insert(boxes.begin(), 2, stray);
      expect_right_in_layers<dim>(boxes, 0.125);
    }
  }
}

/// Clusters change their places, while boxes keep their widths.
TYPED_TEST(LayerBoxesOf, MovedClusters) {
  constexpr int dim = TypeParam::value;
  Boxes<dim> boxes;
  for (std::size_t cluster = 0; cluster < 12; ++cluster) {
    const auto at = static_cast<double>(cluster);
    append<dim>(boxes, mapped<dim>(this->dense(150), 1.0, 1000.0 * at * at));
  }
  expect_right_in_layers<dim>(boxes, 0.0, Way::moved, always_moved);
  expect_right_in_layers<dim>(boxes, 0.25, Way::moved, always_moved);
}

TYPED_TEST(LayerBoxesOf, NumbersOfAnySize) {
  constexpr int dim = TypeParam::value;
  for (const double scale : {0x1p-1000, 0x1p-900, 0x1p-500, 0x1p500, 0x1p900, 0x1p1010}) {
    SCOPED_TRACE("scale " + std::to_string(scale));
    auto boxes = this->dense(700);
    for (auto& box : boxes) box.upper[0] = box.lower[0] + 1.0;  // sizes that no division pays for
    boxes = mapped<dim>(boxes, scale, 0.0);
    expect_right_in_layers<dim>(boxes);
    expect_right_in_layers<dim>(boxes, 0.3 * scale);
    expect_right_in_layers<dim>(
        mapped<dim>(TestFixture::voxels(dim == 2 ? 15 : 6, 1.0), scale, 0.0));
  }
}

/// Widths exceed the largest number.
TYPED_TEST(LayerBoxesOf, TheLargestNumbers) {
  constexpr int dim = TypeParam::value;
  constexpr double largest = std::numeric_limits<double>::max();
  Boxes<dim> boxes(300);
  for (auto& box : boxes) {
    for (double& x : box.lower) x = this->random_.uniform(-1.0, -0.8) * largest;
    for (double& x : box.upper) x = this->random_.uniform(0.8, 1.0) * largest;
  }
  expect_right_in_layers<dim>(boxes);
}

/// Ends are rounded to 2^-12: many coincide.
TYPED_TEST(LayerBoxesOf, FarFromTheOrigin) {
  constexpr int dim = TypeParam::value;
  for (const double offset : {0x1p40, -0x1p40, 0x1p49, 0x1p52}) {
    SCOPED_TRACE("offset " + std::to_string(offset));
    expect_right_in_layers<dim>(mapped<dim>(this->dense(1200), 1.0, offset));
  }
}

/// Boxes of no size and no margin: the reach is 0, or the smallest number.
TYPED_TEST(LayerBoxesOf, PointsAndSubnormalNumbers) {
  constexpr int dim = TypeParam::value;
  auto points = uniform_boxes<dim>(this->random_, 500, {9.0, 9.0, 9.0}, {0.0, 0.0, 0.0});
  append<dim>(points, points);
  expect_right_in_layers<dim>(points);
  const auto voxels = TestFixture::voxels(dim == 2 ? 20 : 7, 1.0);
  expect_right_in_layers<dim>(mapped<dim>(voxels, 0x1p-1074, 0.0));
}

/// From so many boxes on, with the limits that hold: as dense as these, or thinly spread.
TYPED_TEST(LayerBoxesOf, FewAreInTiles) {
  constexpr int dim = TypeParam::value;
  const engine::LayerLimits& limits = without_plane;
  const std::size_t least = dim == 2 ? limits.least_rectangles : limits.least_boxes;
  for (const double neighbors : {0.01, 6.0}) {
    const auto boxes =
        uniform_boxes<dim>(this->random_, least, box_for<dim>(least, neighbors), {0.5, 0.6, 0.7});
    expect_right_in_layers<dim>(boxes, 0.0, Way::layers, limits);
    const Boxes<dim> fewer(boxes.begin(), boxes.end() - 1);
    expect_right_in_layers<dim>(fewer, 0.0, Way::tiles, limits);
  }
}

}  // namespace
}  // namespace abut::testing
