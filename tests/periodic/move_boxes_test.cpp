// How far the ends of boxes are off where they were moved.

#include "periodic/move_boxes.hpp"

#include "lattice/lattices.hpp"
#include "periodic/periodic_search.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class MovedBoxes : public ::testing::Test {};

TYPED_TEST_SUITE(MovedBoxes, Dimensions);

/// Boxes anywhere, small and as wide as some cells; on each axis the stand-in's sphere as
/// exact::Elements says.
template <int Dim>
struct BoxSystem {
  std::vector<exact::Box<Dim>> boxes;
  std::vector<exact::Sphere<Dim>> stand_ins;
  grid::Bounds<Dim> bounds;

  BoxSystem(std::size_t count, double size, double width, Random& random) {
    for (std::size_t k = 0; k < count; ++k) {
      exact::Box<Dim> box;
      exact::Sphere<Dim> sphere{};
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        box.lower[axis] = random.uniform(-size, size);
        box.upper[axis] = box.lower[axis] + random.uniform(0.0, width);
        sphere.center[axis] = box.lower[axis];
        sphere.radius = std::max(sphere.radius, 0.5 * box.upper[axis] - 0.5 * box.lower[axis]);
      }
      boxes.push_back(box);
      stand_ins.push_back(sphere);
    }
    bounds = bounds_of<Dim>(stand_ins);
    bounds.count_largest_twice();
  }
};

/// On each axis one end less the other end of a local element and a ghost, or of two locals, is off
/// by no more than the slack, and so is a width; and that not by far less.
TYPED_TEST(MovedBoxes, AreOffByNoMoreThanTheSlack) {
  constexpr int dim = TypeParam::value;
  Random random(104);
  double worst = 0.0;
  for (int round = 0; round < 100; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    const double size = random_size(named, random);
    const double width = std::array{0.1, 1.0, 2.0}[random.below(3)] * reduced.height[0];
    const BoxSystem<dim> system(6, size, width, random);
    base::MemoryMeter memory;
    auto elements = array_of(system.stand_ins, memory);
    periodic::Images<dim> images(memory);
    images.find(elements, system.bounds, reduced,
                {0.0, 1, kernels::image_kernels(Simd::scalar), Shape::box});
    auto moved = base::make_array_for_overwrite<exact::Box<dim>>(memory, 0);
    periodic::move_boxes<dim>(system.boxes, images, 2, moved);
    const std::size_t locals = system.boxes.size();
    ASSERT_EQ(moved.size(), locals + images.ghosts().size());
    for (std::size_t i = 0; i < locals; ++i) {
      for (std::size_t other = 0; other < moved.size(); ++other) {
        const bool is_ghost = other >= locals;
        const std::size_t j = is_ghost ? images.ghosts()[other - locals].element : other;
        const ImageShift shift = is_ghost ? images.shift_between(i, images.ghosts()[other - locals])
                                          : images.shift_between(i, j);
        for (std::size_t axis = 0; axis < dim; ++axis) {
          const mpq_class exact = exact_difference<dim>(
              system.boxes[i].lower[axis], system.boxes[j].upper[axis], shift, named.lattice, axis);
          ASSERT_EQ(moved[other].lower[axis], images.locals_and_ghosts()[other].center[axis]);
          // As a tile computes it: lower ends and a rounded width.
          const double seen_width = moved[other].upper[axis] - moved[other].lower[axis];
          const mpq_class seen = mpq_class(moved[i].lower[axis]) -
                                 mpq_class(moved[other].lower[axis]) - mpq_class(seen_width);
          const double off = mpq_class(abs(seen - exact)).get_d();
          // Where nothing was moved, the rounding of the width is left, which is the tile's own.
          ASSERT_LE(off, images.slack() + 0x1p-53 * seen_width) << named;
          if (images.slack() == 0.0) continue;
          worst = std::max(worst, off / images.slack());
        }
      }
    }
  }
  EXPECT_GT(worst, 0.002) << "these systems would not show a slack that is too small";
}

/// Where no vector leads along an axis, and where nothing was moved, the ends are those given.
TEST(MovedBoxesOfASlit, KeepTheirEndsAcrossIt) {
  Random random(105);
  const BoxSystem<3> system(60, 0.5, 0.1, random);
  exact::Lattice lattice;
  lattice.vectors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  lattice.periodic = {true, true, false};
  const lattice::ReducedLattice<3> reduced(lattice);
  base::MemoryMeter memory;
  auto elements = array_of(system.stand_ins, memory);
  periodic::Images<3> images(memory);
  images.find(elements, system.bounds, reduced,
              {0.0, 1, kernels::image_kernels(Simd::scalar), Shape::box});
  auto moved = base::make_array_for_overwrite<exact::Box<3>>(memory, 0);
  periodic::move_boxes<3>(system.boxes, images, 1, moved);
  for (std::size_t k = 0; k < system.boxes.size(); ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(moved[k].upper[axis], system.boxes[k].upper[axis]);
    }
  }
  ASSERT_GT(images.ghosts().size(), 5U);
  for (std::size_t g = 0; g < images.ghosts().size(); ++g) {
    const exact::Box<3>& original = system.boxes[images.ghosts()[g].element];
    EXPECT_EQ(moved[system.boxes.size() + g].lower[2], original.lower[2]);
    EXPECT_EQ(moved[system.boxes.size() + g].upper[2], original.upper[2]);
  }
}

}  // namespace
}  // namespace abut::testing
