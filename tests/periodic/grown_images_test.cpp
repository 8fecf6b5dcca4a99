// Each image is grown by what its own place is off, and by no more than that.

#include "periodic/grown_images.hpp"

#include "base/detection_context.hpp"
#include "lattice/lattices.hpp"
#include "periodic/periodic_search.hpp"
#include "support/dimensions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class GrownImages : public ::testing::Test {};

TYPED_TEST_SUITE(GrownImages, Dimensions);

/// Elements of which some lie very near to the origin, in a random lattice.
template <int Dim>
struct SmallSystem {
  NamedLattice<Dim> named;
  lattice::ReducedLattice<Dim> reduced;
  std::vector<exact::Sphere<Dim>> spheres;
  std::vector<exact::Box<Dim>> boxes;

  explicit SmallSystem(Random& random)
      : named(random_lattice<Dim>(random)), reduced(named.lattice) {
    const double size = random_size(named, random);
    for (std::size_t k = 0; k < 6; ++k) {
      exact::Box<Dim> box{};
      exact::Sphere<Dim> sphere{};
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        box.lower[axis] = random.uniform(-size, size) * (k % 2 == 0 ? 1.0 : 0x1p-50);
        box.upper[axis] = box.lower[axis] + random.uniform(0.0, 0.1) * reduced.height[0];
        sphere.center[axis] = box.lower[axis];
        sphere.radius = std::max(sphere.radius, 0.5 * box.upper[axis] - 0.5 * box.lower[axis]);
      }
      boxes.push_back(box);
      spheres.push_back(sphere);
    }
  }

  [[nodiscard]] mpq_class moved(double x, std::size_t axis,
                                const lattice::ImageNumbers& numbers) const {
    return moved_exactly(x, axis, numbers, reduced, named.lattice);
  }
};

template <int Dim>
periodic::Ghost image_of(const periodic::Images<Dim>& images, std::size_t k) {
  const std::size_t locals = images.locals().size;
  if (k < locals) return {static_cast<std::uint32_t>(k), {}};
  return images.ghosts()[k - locals];
}

/// How much of what a sphere was grown by its center is off; nothing is where it was not grown.
template <int Dim>
double share_of_growth(const SmallSystem<Dim>& system, const periodic::Images<Dim>& images,
                       const exact::Sphere<Dim>& grown, std::size_t k) {
  const periodic::Ghost image = image_of(images, k);
  const lattice::ImageNumbers numbers = images.numbers_from_given(image);
  const exact::Sphere<Dim>& given = system.spheres[image.element];
  mpq_class off = 0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const mpq_class component =
        mpq_class(grown.center[axis]) - system.moved(given.center[axis], axis, numbers);
    off += component * component;
  }
  const mpq_class growth = mpq_class(grown.radius) - mpq_class(given.radius);
  EXPECT_LE(off, growth * growth) << system.named;
  if (images.is_as_given(k)) {
    EXPECT_EQ(growth, 0);
  }
  return growth == 0 ? 0.0 : std::sqrt(mpq_class(off / (growth * growth)).get_d());
}

TYPED_TEST(GrownImages, HoldWhatTheirSphereIs) {
  constexpr int dim = TypeParam::value;
  Random random(112);
  double most = 0.0;
  int as_given = 0;
  for (int round = 0; round < 200; ++round) {
    const SmallSystem<dim> system(random);
    base::MemoryMeter memory;
    auto elements = array_of(system.spheres, memory);
    periodic::Images<dim> images(memory);
    images.find(elements, bounds_of<dim>(system.spheres), system.reduced,
                {0.0, 1, kernels::image_kernels(Simd::scalar)});
    periodic::GrownImages<dim> grown(memory);
    base::DetectionContext context;
    grown.place({system.spheres, {}}, images, 2, context.work);
    ASSERT_EQ(grown.elements().size(), images.locals().size + images.ghosts().size());
    for (std::size_t k = 0; k < grown.elements().size(); ++k) {
      most = std::max(most, share_of_growth(system, images, grown.elements()[k], k));
      as_given += images.is_as_given(k) ? 1 : 0;
      EXPECT_LE(grown.elements()[k].radius, grown.bounds().largest_radius);
    }
  }
  EXPECT_GT(most, 0.6) << "these systems would not show a growth that is too small";
  EXPECT_GT(as_given, 50);
}

TYPED_TEST(GrownImages, HoldWhatTheirBoxIs) {
  constexpr int dim = TypeParam::value;
  Random random(113);
  for (int round = 0; round < 200; ++round) {
    const SmallSystem<dim> system(random);
    base::MemoryMeter memory;
    auto elements = array_of(system.spheres, memory);
    grid::Bounds<dim> bounds = bounds_of<dim>(system.spheres);
    bounds.count_largest_twice();
    periodic::Images<dim> images(memory);
    images.find(elements, bounds, system.reduced,
                {0.0, 1, kernels::image_kernels(Simd::scalar), Shape::box});
    periodic::GrownImages<dim> grown(memory);
    base::DetectionContext context;
    grown.place({system.spheres, system.boxes}, images, 1, context.work);
    const auto& boxes = grown.elements().boxes;
    ASSERT_EQ(boxes.size(), images.locals().size + images.ghosts().size());
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const periodic::Ghost image = image_of(images, k);
      const lattice::ImageNumbers numbers = images.numbers_from_given(image);
      const exact::Box<dim>& given = system.boxes[image.element];
      for (std::size_t axis = 0; axis < dim; ++axis) {
        EXPECT_LE(mpq_class(boxes[k].lower[axis]), system.moved(given.lower[axis], axis, numbers));
        EXPECT_GE(mpq_class(boxes[k].upper[axis]), system.moved(given.upper[axis], axis, numbers));
        if (!images.is_as_given(k)) continue;
        EXPECT_EQ(boxes[k].lower[axis], given.lower[axis]);
        EXPECT_EQ(boxes[k].upper[axis], given.upper[axis]);
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
