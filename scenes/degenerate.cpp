// Elements without extent in some direction.

#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cstdint>

namespace abut::scenes {

/// All centres in one point, every radius different, a tenth of them zero: all pairs touch.
Scene make_coincident(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    add_sphere(scene, 0.3, -0.7, 1.9, k % 10 == 9 ? 0.0 : random.uniform());
  }
  return scene;
}

/// A string of beads along x, about half of the neighbours touching.
Scene make_line(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  Scene scene = empty_scene(3, count);
  double x = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    add_sphere(scene, x, 0.0, 0.0, 0.5);
    x += random.uniform(0.5, 1.5);
  }
  return scene;
}

}  // namespace abut::scenes
