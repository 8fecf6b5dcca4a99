#pragma once

#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "scenes/random.hpp"
#include "support/dimensions.hpp"

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {

using scenes::Random;

using testing::Dimensions;

template <int Dim>
using Spheres = std::vector<exact::Sphere<Dim>>;

/// In a box from 0 to `extent` (of which the third is unused in 2D), a radius in [0.1, 0.5).
template <int Dim>
Spheres<Dim> random_spheres(Random& random, std::size_t count,
                            const std::array<double, 3>& extent) {
  Spheres<Dim> spheres(count);
  for (auto& sphere : spheres) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sphere.center[axis] = random.uniform(0.0, extent[axis]);
    }
    sphere.radius = random.uniform(0.1, 0.5);
  }
  return spheres;
}

template <int Dim>
grid::Bounds<Dim> bounds_of(const Spheres<Dim>& spheres) {
  grid::Bounds<Dim> bounds;
  for (const auto& sphere : spheres) {
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
  }
  return bounds;
}

}  // namespace abut::testing
