// How far locals and ghosts are off where they were moved.

#include "periodic/images.hpp"

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
class ImagesSlack : public ::testing::Test {};

TYPED_TEST_SUITE(ImagesSlack, Dimensions);

/// Distances between locals and ghosts are off by no more than the slack, and not by far less.
TYPED_TEST(ImagesSlack, CoversTheRounding) {
  constexpr int dim = TypeParam::value;
  Random random(103);
  double worst = 0.0;
  for (int round = 0; round < 150; ++round) {
    const auto named = random_lattice<dim>(random);
    const lattice::ReducedLattice<dim> reduced(named.lattice);
    std::vector<exact::Sphere<dim>> spheres(6);
    const double size = random_size(named, random);
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x = random.uniform(-size, size);
      sphere.radius = 0.1 * reduced.height[0];
    }
    base::MemoryMeter memory;
    auto elements = array_of(spheres, memory);
    periodic::Images<dim> images(memory);
    images.find(elements, bounds_of<dim>(spheres), reduced,
                {0.0, 1, kernels::image_kernels(Simd::scalar)});
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      for (std::size_t g = 0; g < images.ghosts().size(); ++g) {
        const periodic::Ghost& ghost = images.ghosts()[g];
        const ImageShift shift = images.shift_between(i, ghost);
        const auto& stored = images.locals_and_ghosts()[spheres.size() + g];
        const auto& local = images.locals_and_ghosts()[i];
        mpf_class exact(0, 300);
        mpf_class seen(0, 300);
        for (std::size_t axis = 0; axis < dim; ++axis) {
          const mpq_class component =
              exact_difference<dim>(spheres[i].center[axis], spheres[ghost.element].center[axis],
                                    shift, named.lattice, axis);
          exact += component * component;
          const mpq_class difference =
              mpq_class(local.center[axis]) - mpq_class(stored.center[axis]);
          seen += difference * difference;
        }
        const mpf_class off = abs(sqrt(exact) - sqrt(seen));
        ASSERT_LE(off, mpf_class(images.slack())) << named;
        worst = std::max(worst, off.get_d() / images.slack());
      }
    }
  }
  EXPECT_GT(worst, 0.002) << "these systems would not show a slack that is too small";
}

}  // namespace
}  // namespace abut::testing
