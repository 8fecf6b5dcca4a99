// Boxes of all sizes, each of which looks for smaller ones: the pairs of a direct check, the same
// bytes from every level and number of workers, however little that pays.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

using Vector = std::array<double, 3>;

template <int Dim>
void expect_right_by_size(const Boxes<Dim>& boxes, double margin = 0.0, Way way = Way::layers) {
  expect_right_in_layers<Dim>(boxes, margin, way, always_by_size);
}

template <class Dimension>
class LayerBoxSizesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;
  using ItsBoxes = Boxes<its_dim>;

  /// Widths from 1 to `ratio` on each axis, each octave as often, times a flatness of one axis or
  /// none, in a box that they fill to about that part.
  ItsBoxes log_uniform(std::size_t count, double ratio, double filling, double flatness = 1.0,
                       const Vector& ratios = {1.0, 1.0, 1.0}) {
    ItsBoxes boxes;
    double volume = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const double size = std::exp2(random_.uniform(0.0, std::log2(ratio)));
      Vector widths{};
      double own = 1.0;
      for (std::size_t axis = 0; axis < std::size_t{its_dim}; ++axis) {
        widths[axis] = size * random_.uniform(0.5, 1.0) * (axis == k % 4 ? flatness : 1.0);
        own *= size;
      }
      volume += own;
      boxes.push_back(box_at<its_dim>({}, widths));
    }
    double shape = ratios[0] * ratios[1];
    if (its_dim == 3) shape *= ratios[2];
    const double side = std::pow(volume / filling / shape, 1.0 / its_dim);
    for (auto& box : boxes) {
      for (std::size_t axis = 0; axis < std::size_t{its_dim}; ++axis) {
        const double lower = random_.uniform(0.0, side * ratios[axis]);
        box.upper[axis] += lower;
        box.lower[axis] = lower;
      }
    }
    return boxes;
  }

  Random random_{static_cast<std::uint64_t>(191 + its_dim)};
};

TYPED_TEST_SUITE(LayerBoxSizesOf, Dimensions);

TYPED_TEST(LayerBoxSizesOf, FewBoxes) {
  for (const std::size_t count : {2U, 3U, 17U, 64U, 65U, 300U}) {
    for (const double filling : {0.02, 0.3, 2.0}) {
      SCOPED_TRACE(std::to_string(count) + " boxes, filling " + std::to_string(filling));
      expect_right_by_size<TypeParam::value>(this->log_uniform(count, 8.0, filling));
    }
  }
}

TYPED_TEST(LayerBoxSizesOf, RatiosFromNearlyEqualToHuge) {
  for (const double ratio : {1.01, 4.0, 60.0, 1e3, 1e6, 1e12}) {
    for (const double filling : {0.1, 0.6}) {
      SCOPED_TRACE("ratio " + std::to_string(ratio) + ", filling " + std::to_string(filling));
      expect_right_by_size<TypeParam::value>(this->log_uniform(1800, ratio, filling));
    }
  }
}

/// Plates across each axis and needles along it, in systems of all shapes.
TYPED_TEST(LayerBoxSizesOf, PlatesAndNeedles) {
  constexpr int dim = TypeParam::value;
  for (const double flatness : {0.0, 0.03, 30.0}) {
    for (const auto& ratios : box_shapes(20.0)) {
      SCOPED_TRACE("flatness " + std::to_string(flatness) + ", " + std::to_string(ratios[0]) +
                   " : " + std::to_string(ratios[1]));
      expect_right_by_size<dim>(this->log_uniform(900, 12.0, 0.2, flatness, ratios));
    }
  }
}

/// Of two as wide the one with the higher number finds the pair.
TYPED_TEST(LayerBoxSizesOf, EqualSizesBesideLargerOnes) {
  constexpr int dim = TypeParam::value;
  for (const double large : {1.0, 2.0, 3.0, 10.0, 40.0}) {
    SCOPED_TRACE("large ones " + std::to_string(large));
    auto boxes = uniform_boxes<dim>(this->random_, 2000, box_for<dim>(2000, 0.8));
    for (auto& box : boxes) box.upper[0] = box.lower[0] + 1.0;
    for (std::size_t k = 0; k < boxes.size(); k += large < 5.0 ? 3 : 100) {
      boxes[k].upper[k % dim] = boxes[k].lower[k % dim] + large;
    }
    boxes.front().upper[0] += 0.25;
    expect_right_by_size<dim>(boxes);
    expect_right_by_size<dim>(boxes, 0.1);
  }
}

TYPED_TEST(LayerBoxSizesOf, Margins) {
  constexpr int dim = TypeParam::value;
  const auto boxes = this->log_uniform(1200, 50.0, 0.05);
  for (const double margin : {1e-12, 0.5, 5.0, 100.0}) {
    SCOPED_TRACE("margin " + std::to_string(margin));
    expect_right_by_size<dim>(boxes, margin);
  }
}

/// Walls at the ends of each axis, and boxes that touch them exactly or nearly so; one box that all
/// others lie in; one that is wider than single precision says of squares.
TYPED_TEST(LayerBoxSizesOf, WallsAndGiants) {
  constexpr int dim = TypeParam::value;
  auto boxes = this->log_uniform(1500, 10.0, 0.1);
  double end = 0.0;
  for (const auto& box : boxes) end = std::max(end, *std::max_element(box.upper, box.upper + dim));
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    for (const double at : {-1.0, end}) {
      Vector lower{};
      Vector widths{end, end, end};
      lower[axis] = at;
      widths[axis] = 1.0;
      boxes.push_back(box_at<dim>(lower, widths));
      for (std::size_t k = axis; k < 300; k += dim) {
        boxes[k].upper[axis] = at;
        if (k % 2 == 0) boxes[k].upper[axis] = std::nextafter(at, -1e9);
        boxes[k].lower[axis] = std::min(boxes[k].lower[axis], at - 0.5);
      }
    }
  }
  expect_right_by_size<dim>(boxes);
  for (const double wide : {1e4, 1e9, 1e12}) {
    SCOPED_TRACE("width " + std::to_string(wide));
    boxes[777].upper[0] = boxes[777].lower[0] + wide;
    expect_right_by_size<dim>(boxes);
    expect_right_by_size<dim>(boxes, 0.5);
  }
  boxes[777].upper[0] = 1e40;
  expect_right_by_size<dim>(boxes, 0.0, Way::tiles);
}

/// A box a thousand cells wide, and small ones that end where it begins, or begin where it ends, or
/// nearly so: nearer than single precision tells.
TYPED_TEST(LayerBoxSizesOf, SmallOnesThatTouchALargeOne) {
  constexpr int dim = TypeParam::value;
  const double large = 1000.123;
  auto boxes = uniform_boxes<dim>(this->random_, 2500, {2000.0, 1.0, 1.0}, {0.4, 0.4, 0.4});
  boxes.front() = box_at<dim>({0.0, -0.5, -0.5}, {large, large, large});
  for (std::size_t k = 1; k < 600; ++k) {
    const double off = std::exp2(this->random_.uniform(-33.0, -20.0)) * large;
    const double near = k % 2 == 0 ? off : -off;
    const std::size_t axis = k % dim;
    if (k % 3 == 0) {
      boxes[k].lower[axis] = boxes.front().lower[axis] - 0.3;
      boxes[k].upper[axis] = boxes.front().lower[axis] + near;
    } else {
      boxes[k].lower[axis] = boxes.front().upper[axis] + (k % 3 == 1 ? near : 0.0);
      boxes[k].upper[axis] = boxes[k].lower[axis] + 0.3;
    }
  }
  expect_right_by_size<dim>(boxes);
}

/// Boxes of no size, and many in one place.
TYPED_TEST(LayerBoxSizesOf, PointsAndCrowds) {
  constexpr int dim = TypeParam::value;
  auto boxes = this->log_uniform(800, 10.0, 0.2);
  for (std::size_t k = 0; k < boxes.size(); k += 2) {
    std::copy_n(boxes[k].lower, dim, boxes[k].upper);
  }
  append<dim>(boxes, Boxes<dim>(boxes));
  append<dim>(boxes, Boxes<dim>(150, boxes[1]));
  append<dim>(boxes, Boxes<dim>(40, boxes[2]));
  expect_right_by_size<dim>(boxes);
  expect_right_by_size<dim>(boxes, 0.25);
}

/// Own reaches within a few units of half a cell and of a cell.
TYPED_TEST(LayerBoxSizesOf, OwnReachesAtTheBorders) {
  constexpr int dim = TypeParam::value;
  auto boxes = this->log_uniform(2500, 3.0, 0.4);
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const double step = std::exp2(-static_cast<double>(k % 24));
    const double width = 3.0 * (k % 2 == 0 ? 0.5 + step : 1.0 / (1.0 + step));
    boxes[k].upper[k % dim] = boxes[k].lower[k % dim] + width;
  }
  expect_right_by_size<dim>(boxes);
}

TYPED_TEST(LayerBoxSizesOf, NumbersOfAnySizeAndPlace) {
  constexpr int dim = TypeParam::value;
  for (const double factor : {0x1p-1060, 0x1p-900, 0x1p-500, 0x1p500, 0x1p900, 0x1p1000}) {
    SCOPED_TRACE("factor " + std::to_string(factor));
    const auto boxes = mapped<dim>(this->log_uniform(600, 100.0, 0.3), factor, 0.0);
    expect_right_by_size<dim>(boxes);
    expect_right_by_size<dim>(boxes, 2.0 * factor);
  }
  for (const double offset : {0x1p40, -0x1p49}) {
    SCOPED_TRACE("offset " + std::to_string(offset));
    expect_right_by_size<dim>(mapped<dim>(this->log_uniform(900, 20.0, 0.3), 1.0, offset));
  }
  for (const double distance : {1e4, 1e9, 1e300}) {
    SCOPED_TRACE("stray at " + std::to_string(distance));
    auto boxes = this->log_uniform(300, 20.0, 0.3);
    boxes.front().lower[0] = distance;
    boxes.front().upper[0] = distance * 1.5;
    expect_right_by_size<dim>(boxes);
  }
}

/// A wall is tested against what is beside it, not against all in front of it.
TYPED_TEST(LayerBoxSizesOf, TestsFollowTheSmallerOnes) {
  constexpr int dim = TypeParam::value;
  auto boxes = this->log_uniform(20000, 100.0, 0.3);
  const LayerRun by_size = run_rows<dim>(boxes, {0.0, 1, Simd::scalar, always_by_size});
  ASSERT_TRUE(by_size.in_layers);
  EXPECT_LT(by_size.candidate_tests, 60 * boxes.size());
  Vector widths{1e3, 1e3, 1e3};
  widths[0] = 1.0;
  boxes.push_back(box_at<dim>({0.0, 0.0, 0.0}, widths));
  const LayerRun with_wall = run_rows<dim>(boxes, {0.0, 1, Simd::scalar, always_by_size});
  ASSERT_TRUE(with_wall.in_layers);
  EXPECT_LT(with_wall.candidate_tests, by_size.candidate_tests + boxes.size() / 2);
}

/// From so many boxes on, with the limits that hold, where their sizes differ much.
TEST(LayerBoxSizes, FewAreInTiles) {
  Random random(197);
  const engine::LayerLimits limits;
  const std::size_t least = limits.least_boxes_by_size;
  auto boxes = uniform_boxes<3>(random, least, box_for<3>(least, 0.1));
  for (std::size_t k = 0; k < least; ++k) {
    boxes[k].upper[0] = boxes[k].lower[0] + (k % 100 == 0 ? 10.0 : 1.0);
  }
  expect_right_in_layers<3>(boxes, 0.0, Way::layers, limits);
  boxes.pop_back();
  expect_right_in_layers<3>(boxes, 0.0, Way::tiles, limits);
}

/// Boxes of a few sizes that crowd stay in layers of one reach: tiles would test more of them.
TYPED_TEST(LayerBoxSizesOf, CrowdsAreInLayers) {
  constexpr int dim = TypeParam::value;
  EXPECT_TRUE(
      (run_rows<dim>(this->log_uniform(10000, 3.0, 2.0), {0.0, 2, Simd::scalar}).in_layers));
}

}  // namespace
}  // namespace abut::testing
