// Sets whose crowds are cut out of their layers and searched as sets of their own, forced where few
// elements crowd: parts of parts, marks of those around them, and the order of what is found.

#include "engine/layers/layer_box_run.hpp"
#include "engine/layers/layer_run.hpp"
#include "engine/layers/layer_scenes.hpp"
#include "support/crowded_systems.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace abut::testing {
namespace {

template <class Dimension>
class CrowdSearchOf : public ::testing::Test {
 protected:
  static constexpr int its_dim = Dimension::value;

  /// Around a point at distances that spread over so many decades, each as often.
  Spheres<its_dim> around_a_point(std::size_t count, double decades, double radius = half) {
    auto spheres = uniform_spheres<its_dim>(random_, count, {2.0, 2.0, 2.0}, radius);
    for (auto& sphere : spheres) {
      const double distance = std::pow(10.0, decades * random_.uniform(0.0, 1.0));
      for (double& x : sphere.center) x = (x - 1.0) * distance;
    }
    return spheres;
  }

  Random random_{static_cast<std::uint64_t>(71 + its_dim)};
};

TYPED_TEST_SUITE(CrowdSearchOf, Dimensions);

template <int Dim>
Spheres<Dim> spheres_of(const scenes::Scene& scene) {
  Spheres<Dim> spheres;
  for (std::size_t k = 0; k < scene.size(); ++k) {
    const double z = Dim == 2 ? 0.0 : scene.z[k];
    spheres.push_back(sphere_at<Dim>({scene.x[k], scene.y[k], z}, scene.radius[k]));
  }
  return spheres;
}

TYPED_TEST(CrowdSearchOf, DistancesOfManyScales) {
  constexpr int dim = TypeParam::value;
  for (const double decades : {1.0, 3.0, 9.0, 40.0, 250.0}) {
    SCOPED_TRACE(std::to_string(decades) + " decades");
    const auto spheres = this->around_a_point(1200, decades);
    for (const double margin : {0.0, 0.7}) {
      expect_right_in_layers<dim>(spheres, margin, Way::layers, always_in_parts);
    }
  }
}

TYPED_TEST(CrowdSearchOf, SizesOfManyScales) {
  constexpr int dim = TypeParam::value;
  for (const double decades : {0.3, 1.0, 3.0, 6.0}) {
    SCOPED_TRACE(std::to_string(decades) + " decades");
    auto spheres = this->around_a_point(1000, 4.0);
    for (auto& sphere : spheres) {
      sphere.radius = 0.3 * std::pow(10.0, decades * this->random_.uniform(-0.5, 0.5));
    }
    expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_parts);
  }
}

/// Crowds whose elements meet those of the rest of their layer, of the next one, and of each other,
/// across the faces of cells, which are wider than the reach.
TYPED_TEST(CrowdSearchOf, CrowdsAmongOthers) {
  constexpr int dim = TypeParam::value;
  for (const double width : {0.1, 0.6, 1.5, 4.0}) {
    SCOPED_TRACE("crowds " + std::to_string(width) + " wide");
    const auto extent = box_for<dim>(1500, 0.2);
    auto spheres = uniform_spheres<dim>(this->random_, 1500, extent);
    for (int crowd = 0; crowd < 12; ++crowd) {
      const auto middle = uniform_spheres<dim>(this->random_, 1, extent)[0];
      for (auto sphere : uniform_spheres<dim>(this->random_, 60, {width, width, width})) {
        for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
          sphere.center[axis] += middle.center[axis];
        }
        spheres.push_back(sphere);
      }
    }
    expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_parts);
    for (auto& sphere : spheres) sphere.radius = this->random_.uniform(0.05, half);
    expect_right_in_layers<dim>(spheres, 0.1, Way::layers, always_in_parts);
  }
}

/// Clouds, filaments and sheets within each other, with radii over many decades.
TYPED_TEST(CrowdSearchOf, CrowdedSystems) {
  constexpr int dim = TypeParam::value;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const CrowdedSystem system = crowded_system(dim, 500, seed);
    expect_right_in_layers<dim>(spheres_of<dim>(system.scene), system.margin, Way::layers,
                                always_in_parts);
  }
}

TYPED_TEST(CrowdSearchOf, AllInOnePlaceBesideOneFarAway) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres(300, sphere_at<dim>({3.0, 4.0, 5.0}));
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_parts);
  spheres.push_back(sphere_at<dim>({1e300, 4.0, 5.0}));
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_parts);
}

/// Pairs that touch exactly, which copies must not have moved.
TYPED_TEST(CrowdSearchOf, LatticesThatTouch) {
  constexpr int dim = TypeParam::value;
  auto spheres = cubic_lattice<dim>(dim == 2 ? 20 : 7);
  for (auto sphere : cubic_lattice<dim>(dim == 2 ? 20 : 7)) {
    for (double& x : sphere.center) x = 0x1p-20 * x + 1e6;
    sphere.radius = 0x1p-21;
    spheres.push_back(sphere);
  }
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_parts);
}

TYPED_TEST(CrowdSearchOf, BoxesOfManyScales) {
  constexpr int dim = TypeParam::value;
  for (const double decades : {1.0, 4.0, 60.0}) {
    SCOPED_TRACE(std::to_string(decades) + " decades");
    auto boxes = uniform_boxes<dim>(this->random_, 900, {2.0, 2.0, 2.0});
    for (auto& box : boxes) {
      const double distance = std::pow(10.0, decades * this->random_.uniform(0.0, 1.0));
      for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
        const double width = box.upper[axis] - box.lower[axis];
        box.lower[axis] = (box.lower[axis] - 1.0) * distance;
        box.upper[axis] = box.lower[axis] + width;
      }
    }
    expect_right_in_layers<dim>(boxes, 0.0, Way::layers, always_in_parts);
    expect_right_in_layers<dim>(boxes, 0.3, Way::layers, always_in_parts);
  }
}

/// Axes with far more cells than positions have bits for, along which sets are cut into slices.
TYPED_TEST(CrowdSearchOf, RodsOfManyCells) {
  constexpr int dim = TypeParam::value;
  for (std::size_t axis = 0; axis < std::size_t{dim}; ++axis) {
    for (const double length : {30'000.0, 300'000.0, 3e7}) {
      SCOPED_TRACE("axis " + std::to_string(axis) + ", " + std::to_string(length) + " long");
      std::array<double, 3> extent{1.5, 1.5, 1.5};
      extent[axis] = length;
      auto spheres = uniform_spheres<dim>(this->random_, 3000, extent);
      for (std::size_t k = 0; k + 1 < spheres.size(); k += 3) {
        spheres[k + 1].center[axis] = spheres[k].center[axis] + this->random_.uniform(0.0, 1.5);
      }
      engine::LayerLimits limits = always_in_parts;
      expect_right_in_layers<dim>(spheres, 0.0, Way::layers, limits);
      limits.least_in_run_of_crowd = engine::LayerLimits{}.least_in_run_of_crowd;
      limits.least_in_crowd = engine::LayerLimits{}.least_in_crowd;
      expect_right_in_layers<dim>(spheres, 0.0, Way::layers, limits);
    }
  }
}

/// Parts of so many parts that most wait until those around them are done.
TYPED_TEST(CrowdSearchOf, DeepParts) {
  constexpr int dim = TypeParam::value;
  Spheres<dim> spheres;
  double distance = 1e300;
  for (int k = 0; k < 900; ++k) {
    spheres.push_back(sphere_at<dim>({distance, -distance, 0.5 * distance}));
    distance *= 0.45;
  }
  expect_right_in_layers<dim>(spheres, 0.0, Way::layers, always_in_parts);
}

/// Elements most of which are in one crowd; other crowds, and sizes that differ, stay in tiles.
TYPED_TEST(CrowdSearchOf, AsManyAsPay) {
  constexpr int dim = TypeParam::value;
  const engine::LayerLimits limits;
  const auto expect_in_layers = [&](bool expected, const Spheres<dim>& spheres) {
    SCOPED_TRACE(std::to_string(spheres.size()) + " spheres");
    const engine::RowsSettings settings{0.0, 1, Simd::scalar, limits};
    EXPECT_EQ(run_rows<dim>(spheres, settings).in_layers, expected);
  };
  const std::size_t least = limits.least_elements_of_one_crowd;
  expect_in_layers(false, this->around_a_point(least - 1, 9.0, 1e-3));
  auto spheres = this->around_a_point(least, 9.0, 1e-3);
  expect_in_layers(true, spheres);
  spheres[0].radius = 2.0 * spheres[1].radius * (1.0 + 0x1p-50);
  expect_in_layers(false, spheres);
  auto apart = this->around_a_point(least, 9.0, 1e-3);
  for (std::size_t k = 0; k < least; ++k) {
    for (double& x : apart[k].center) x += 1e11 * static_cast<double>(k % 4);
  }
  expect_in_layers(false, apart);
}

}  // namespace
}  // namespace abut::testing
