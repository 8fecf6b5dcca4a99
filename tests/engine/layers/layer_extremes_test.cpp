// Strays, very small and very large numbers, and numbers with few digits left: layers are right, or
// clusters are moved where positions have too few bits.

#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class LayerExtremesOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  Spheres<its_dim> system(std::size_t count, double neighbors) {
    return uniform_spheres<its_dim>(random_, count, box_for<its_dim>(count, neighbors));
  }

  /// Each number times `scale`, and each center moved by `offset`.
  static Spheres<its_dim> mapped(Spheres<its_dim> spheres, double scale, double offset) {
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) x = x * scale + offset;
      sphere.radius *= scale;
    }
    return spheres;
  }

  Random random_{static_cast<std::uint64_t>(91 + its_dim)};
};

TYPED_TEST_SUITE(LayerExtremesOf, Dimensions);

TYPED_TEST(LayerExtremesOf, FarStraysOnEachAxis) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {1e3, 1e9, 0x1p60, 1e300}) {
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      SCOPED_TRACE(std::to_string(distance) + " away on axis " + std::to_string(axis));
      auto spheres = this->system(500, 6.0);
      auto stray = spheres[7];
      stray.center[axis] += distance;
      spheres.push_back(stray);
      expect_right_in_layers<dim>(spheres);
      stray.center[axis] = -distance;
      spheres.insert(spheres.begin(), 2, stray);
      expect_right_in_layers<dim>(spheres);
    }
  }
}

/// One element to a cell, and more narrow cells than positions have bits for.
TYPED_TEST(LayerExtremesOf, LinesThatAreThinlyFilled) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {0.9, 2.5, 20.0, 60.0}) {
    for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
      SCOPED_TRACE(std::to_string(distance) + " from one to the next, axis " +
                   std::to_string(axis));
      Spheres<dim> spheres(700, sphere_at<dim>({0.0, 0.0, 0.0}));
      for (std::size_t k = 0; k < spheres.size(); ++k) {
        spheres[k].center[axis] = distance * static_cast<double>(k);
      }
      expect_right_in_layers<dim>(spheres);
    }
  }
}

/// More elements, and so more cells than positions have bits for: clusters are moved.
TYPED_TEST(LayerExtremesOf, TooManyCellsAlongAnAxisBecomeFewer) {
  constexpr int dim = TypeParam::value;
  for (const double distance : {1e9, 0x1p60}) {
    auto spheres = this->system(34000, 6.0);
    spheres[7].center[0] += distance;
    expect_right_in_layers<dim>(spheres, 0.0, Way::moved);
  }
}

TYPED_TEST(LayerExtremesOf, NumbersOfAnySize) {
  constexpr int dim = TypeParam::value;
  for (const double scale : {0x1p-1000, 0x1p-900, 0x1p-500, 1.0, 0x1p500, 0x1p900, 0x1p1010}) {
    SCOPED_TRACE("scale " + std::to_string(scale));
    const auto spheres = this->mapped(this->system(900, 6.0), scale, 0.0);
    expect_right_in_layers<dim>(spheres);
    expect_right_in_layers<dim>(spheres, 0.3 * scale);
    expect_right_in_layers<dim>(
        this->mapped(shuffled<dim>(cubic_lattice<dim>(9), this->random_), scale, 0.0));
  }
}

/// Coordinates are rounded to 2^-12: many distances are the reach, and many elements stand on
/// faces.
TYPED_TEST(LayerExtremesOf, FarFromTheOrigin) {
  constexpr int dim = TypeParam::value;
  for (const double offset : {0x1p40, -0x1p40, 0x1p49, 0x1p52}) {
    SCOPED_TRACE("offset " + std::to_string(offset));
    expect_right_in_layers<dim>(this->mapped(this->system(1500, 6.0), 1.0, offset));
    expect_right_in_layers<dim>(this->mapped(cubic_lattice<dim>(9), 1.0, offset));
  }
}

/// Elements of no size and no margin in a box of any size: the reach is 0.
TYPED_TEST(LayerExtremesOf, ReachOfZero) {
  constexpr int dim = TypeParam::value;
  for (const double scale : {0x1p-900, 1.0, 0x1p900}) {
    auto points = this->mapped(this->system(600, 6.0), scale, 0.0);
    for (auto& point : points) point.radius = 0.0;
    append<dim>(points, points);
    expect_right_in_layers<dim>(points);
  }
}

/// Centers that differ by the smallest numbers there are.
TYPED_TEST(LayerExtremesOf, SubnormalNumbers) {
  constexpr int dim = TypeParam::value;
  auto spheres = cubic_lattice<dim>(dim == 2 ? 20 : 7);
  for (auto& sphere : spheres) {
    for (double& x : sphere.center) x *= 0x1p-1073;
    sphere.radius = 0x1p-1074;
  }
  expect_right_in_layers<dim>(spheres);
}

}  // namespace
}  // namespace abut::testing
