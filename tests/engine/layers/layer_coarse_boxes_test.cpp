// Walls and other large boxes beside layers of all others: the pairs of a direct check, the same
// bytes from every level and number of workers, however little that pays.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

using Vector = std::array<double, 3>;

template <class Dimension>
class LayerCoarseBoxesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  /// Widths up to 1, in a cube with that side from 0 on, which they fill to about a half.
  Boxes<its_dim> others(std::size_t count, double side) {
    return uniform_boxes<its_dim>(random_, count, {side, side, side});
  }
  static double side_for(std::size_t count) {
    return std::pow(static_cast<double>(count) / 3.0, 1.0 / its_dim);
  }

  Random random_{static_cast<std::uint64_t>(291 + its_dim)};
};

TYPED_TEST_SUITE(LayerCoarseBoxesOf, Dimensions);

/// On all sides: thick ones and thin ones, as long as the cube or much longer, from some way off to
/// some way in.
TYPED_TEST(LayerCoarseBoxesOf, WallsOnAllSides) {
  constexpr int dim = TypeParam::value;
  const double side = TestFixture::side_for(1200);
  const auto others = this->others(1200, side);
  for (const double longer : {0.0, 1.0, 5000.0}) {
    for (const double thick : {0.0, 0.3, 4.0, 3000.0}) {
      SCOPED_TRACE(std::to_string(longer) + " longer, " + std::to_string(thick) + " thick");
      auto boxes = others;
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
        for (const double at : {-0.5, 0.4}) {
          Vector lower{-longer, -longer, -longer};
          Vector widths{side + 2.0 * longer, side + 2.0 * longer, side + 2.0 * longer};
          lower[axis] = at < 0.0 ? at - thick : side + at;
          widths[axis] = thick;
          boxes.insert(boxes.begin() + 300, box_at<dim>(lower, widths));
        }
      }
      expect_right_beside<dim>(std::size_t{2 * dim}, boxes, longer == 1.0 ? 0.25 : 0.0);
    }
  }
}

/// Beside the ends of a large one, 2^-33 to 2^-20 of its width apart or into it, on each axis.
TYPED_TEST(LayerCoarseBoxesOf, OthersThatTouchIt) {
  constexpr int dim = TypeParam::value;
  for (const double large : {5.0, 130.0, 7000.0}) {
    for (const double begin : {0.0, -0.6, -40.0}) {
      SCOPED_TRACE("width " + std::to_string(large) + " from " + std::to_string(begin));
      auto boxes = this->others(1000, 30.0);
      const double lower = begin * large;
      const double width = 30.0 - lower;
      boxes.push_back(box_at<dim>({lower, lower, lower}, {width, width, width}));
      for (std::size_t k = 0; k < 300; ++k) {
        const double off = large * std::exp2(this->random_.uniform(-33.0, -20.0));
        const std::size_t axis = k % dim;
        const double x = 30.0 + (k % 2 == 0 ? off : -off);
        boxes[k].upper[axis] += x - boxes[k].lower[axis];
        boxes[k].lower[axis] = x;
      }
      expect_right_beside<dim>(1, boxes);
    }
  }
}

/// As many as are taken one by one, of all widths, that overlap, touch or miss each other.
TYPED_TEST(LayerCoarseBoxesOf, ManyOfThem) {
  constexpr int dim = TypeParam::value;
  const double side = TestFixture::side_for(1600);
  auto boxes = this->others(1600, side);
  for (std::size_t k = 0; k < 40; ++k) {
    Vector lower{};
    Vector widths{};
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      lower[axis] = std::floor(this->random_.uniform(-0.5, 1.0) * side);
      widths[axis] = std::floor(this->random_.uniform(0.0, 6.0));
    }
    widths[k % dim] = 8.0;
    boxes[40 * k] = box_at<dim>(lower, widths);
  }
  expect_right_beside<dim>(40, boxes);
  expect_right_beside<dim>(40, boxes, 0.125);
}

TYPED_TEST(LayerCoarseBoxesOf, NumbersOfAnySize) {
  constexpr int dim = TypeParam::value;
  const double side = TestFixture::side_for(800);
  auto boxes = this->others(800, side);
  boxes.push_back(box_at<dim>({-3.0, -1.0, -1.0}, {3.0, side + 2.0, side + 2.0}));
  for (const double factor : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) {
    SCOPED_TRACE(factor);
    expect_right_in_layers<dim>(mapped<dim>(boxes, factor, 0.0), 0.0, Way::layers,
                                always_beside_coarse);
  }
  expect_right_in_layers<dim>(mapped<dim>(boxes, 1.0, 0x1p40), 0.0, Way::layers,
                              always_beside_coarse);
}

/// As wide as doubles are: another search is taken.
TYPED_TEST(LayerCoarseBoxesOf, LargerOnesThanSquaresHold) {
  constexpr int dim = TypeParam::value;
  auto boxes = this->others(800, 20.0);
  for (const double width : {0x1p34, 0x1p42, 1e300}) {
    SCOPED_TRACE(width);
    boxes[7] = box_at<dim>({-width, -width, -width}, {2.0 * width, 1.5 * width, 1.5 * width});
    expect_right_beside<dim>(width < 0x1p37 ? 1 : 0, boxes);
  }
}

}  // namespace
}  // namespace abut::testing
