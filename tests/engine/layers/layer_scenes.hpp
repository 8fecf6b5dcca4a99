#pragma once

#include "engine/layers/layer_grid.hpp"
#include "engine/random_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace abut::testing {

/// Spheres of radius 1/2, so that the reach is 1 where no margin is added.
inline constexpr double half = 0.5;

template <int Dim>
exact::Sphere<Dim> sphere_at(const std::array<double, 3>& center, double radius = half) {
  exact::Sphere<Dim> sphere{};
  for (std::size_t axis = 0; axis < Dim; ++axis) sphere.center[axis] = center[axis];
  sphere.radius = radius;
  return sphere;
}

template <int Dim>
Spheres<Dim> uniform_spheres(Random& random, std::size_t count, const std::array<double, 3>& extent,
                             double radius = half) {
  Spheres<Dim> spheres = random_spheres<Dim>(random, count, extent);
  for (auto& sphere : spheres) sphere.radius = radius;
  return spheres;
}

/// A box with sides in these ratios in which so many spheres have so many neighbours on average.
template <int Dim>
std::array<double, 3> box_for(std::size_t count, double neighbors,
                              const std::array<double, 3>& ratios = {1.0, 1.0, 1.0}) {
  const double ball = Dim == 2 ? 3.14159 : 4.18879;
  double shape = ratios[0] * ratios[1];
  if (Dim == 3) shape *= ratios[2];
  const double volume = static_cast<double>(count) * ball / neighbors;
  const double side = std::pow(volume / shape, 1.0 / Dim);
  return {side * ratios[0], side * ratios[1], side * ratios[2]};
}

/// Sides of boxes in each order of their lengths, and of flat ones across each axis.
[[nodiscard]] inline std::vector<std::array<double, 3>> box_shapes(double flat) {
  return {{1.0, 3.0, 9.0}, {1.0, 9.0, 3.0},   {3.0, 1.0, 9.0},   {9.0, 1.0, 3.0},  {3.0, 9.0, 1.0},
          {9.0, 3.0, 1.0}, {1.0, flat, flat}, {flat, 1.0, flat}, {flat, flat, 1.0}};
}

/// Neighbors at distance 1 along each axis.
template <int Dim>
Spheres<Dim> cubic_lattice(std::size_t side) {
  Spheres<Dim> spheres;
  const std::size_t layers = Dim == 2 ? 1 : side;
  for (std::size_t k = 0; k < side * side * layers; ++k) {
    spheres.push_back(
        sphere_at<Dim>({static_cast<double>(k % side), static_cast<double>(k / side % side),
                        static_cast<double>(k / side / side)}));
  }
  return spheres;
}

/// In 2D six neighbors each, in 3D (face-centred) twelve, which touch or fail to by the rounding of
/// their radius.
template <int Dim>
Spheres<Dim> closest_lattice(std::size_t side) {
  const double tall = Dim == 2 ? std::sqrt(3.0) : 1.0;
  Spheres<Dim> spheres;
  const std::size_t layers = Dim == 2 ? 1 : side;
  for (std::size_t k = 0; k < side * side * layers; ++k) {
    const std::array<std::size_t, 3> at{k % side, k / side % side, k / side / side};
    if ((at[0] + at[1] + at[2]) % 2 != 0) continue;
    const auto x = static_cast<double>(at[0]);
    const auto y = tall * static_cast<double>(at[1]);
    const auto z = static_cast<double>(at[2]);
    spheres.push_back(sphere_at<Dim>({x, y, z}, Dim == 2 ? 1.0 : std::sqrt(half)));
  }
  return spheres;
}

/// All lengths a tenth, rounded: neighbors touch or fail to, and no power of two divides all.
template <int Dim>
Spheres<Dim> in_tenths(Spheres<Dim> spheres) {
  for (auto& sphere : spheres) {
    for (double& x : sphere.center) x *= 0.1;
    sphere.radius *= 0.1;
  }
  return spheres;
}

/// As std::shuffle does, but with the same result from every standard library.
template <int Dim>
Spheres<Dim> shuffled(Spheres<Dim> spheres, Random& random) {
  for (std::size_t k = spheres.size(); k > 1; --k) {
    std::swap(spheres[k - 1], spheres[random.below(k)]);
  }
  return spheres;
}

/// Spheres in one place or near it, in clumps of 1 to `largest`.
template <int Dim>
Spheres<Dim> clumps(Random& random, std::size_t count, std::size_t largest,
                    const std::array<double, 3>& extent, double spread) {
  Spheres<Dim> spheres;
  while (spheres.size() < count) {
    const auto center = uniform_spheres<Dim>(random, 1, extent).front();
    const std::size_t size = std::min(count - spheres.size(), 1 + random.below(largest));
    for (std::size_t k = 0; k < size; ++k) {
      spheres.push_back(center);
      for (double& x : spheres.back().center) x += random.uniform(0.0, spread);
    }
  }
  return spheres;
}

/// The grid over the box of some elements of this reach, whatever their radii.
template <int Dim>
std::optional<engine::LayerGrid<Dim>> layer_grid_over(grid::Bounds<Dim> bounds, double reach,
                                                      double least_cell, std::size_t elements) {
  bounds.smallest_radius = bounds.largest_radius = bounds.second_largest_radius = half * reach;
  return engine::LayerGrid<Dim>::over(bounds, 0.0, least_cell, elements);
}

template <int Dim>
void append(Spheres<Dim>& spheres, const Spheres<Dim>& more) {
  spheres.insert(spheres.end(), more.begin(), more.end());
}

/// A few last places further or nearer.
inline double beside(Random& random, double x) {
  const auto steps = static_cast<int>(random.below(5)) - 2;
  for (int k = 0; k < std::abs(steps); ++k) x = std::nextafter(x, steps < 0 ? -1e9 : 1e9);
  return x;
}

}  // namespace abut::testing
