#include "scenes/box_scene.hpp"

#include "scenes/random.hpp"

namespace abut::scenes {

BoxScene boxes_in(const Scene& scene, std::uint64_t seed) {
  Random random(seed);
  BoxScene boxes;
  boxes.dimensions = scene.dimensions;
  const std::vector<double>* const center[3] = {&scene.x, &scene.y, &scene.z};
  for (std::size_t k = 0; k < scene.size(); ++k) {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(scene.dimensions); ++axis) {
      const double half = scene.radius[k] * random.uniform(0.2, 1.0);
      boxes.lower[axis].push_back((*center[axis])[k] - half);
      boxes.upper[axis].push_back((*center[axis])[k] + half);
    }
  }
  return boxes;
}

}  // namespace abut::scenes
