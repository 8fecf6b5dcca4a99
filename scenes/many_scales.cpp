#include "scenes/many_scales.hpp"

#include "scenes/random.hpp"

#include <array>
#include <cmath>

namespace abut::scenes {
namespace {

double radius_at(double distance, Radii radii) {
  if (radii == Radii::equal) return 0.3;
  return radii == Radii::as_root ? 0.3 * std::sqrt(distance) : 0.01 * distance;
}

}  // namespace

Scene spheres_of_scales(const ManyScales& what, double decades, std::size_t count) {
  Scene scene;
  scene.dimensions = 3;
  Random random(count);
  const auto over_decades = [&] { return std::pow(10.0, decades * random.uniform()); };
  for (std::size_t k = 0; k < count; ++k) {
    std::array<double, 3> center{over_decades(), 0.0, 0.0};
    if (what.directions == Directions::all) {
      const double distance = center[0];
      for (double& x : center) x = distance * random.uniform(-1.0, 1.0);
    } else if (what.directions == Directions::near_three_axes) {
      for (double& x : center) x = over_decades();
    }
    scene.x.push_back(center[0]);
    scene.y.push_back(center[1]);
    scene.z.push_back(center[2]);
    const double distance = std::hypot(center[0], center[1], center[2]);
    scene.radius.push_back(radius_at(distance, what.radii) *
                           std::pow(what.ratio, random.uniform()));
  }
  return scene;
}

}  // namespace abut::scenes
