#pragma once

#include "scenes/scene.hpp"

#include <cstddef>

namespace abut::scenes {

/// Directions from a point, and how radii go with the distance from it.
enum class Directions { all, one_ray, near_three_axes };
enum class Radii { equal, as_root, as_distance };

/// Spheres around a point, and the ratio of their largest radius to the smallest at a distance.
struct ManyScales {
  Directions directions = Directions::all;
  Radii radii = Radii::equal;
  double ratio = 1.0;
};

/// Spheres at distances that spread over so many decades from 1 on, each as often; near the axes
/// each coordinate does. In all directions density spans three times as many decades.
[[nodiscard]] Scene spheres_of_scales(const ManyScales& what, double decades, std::size_t count);

}  // namespace abut::scenes
