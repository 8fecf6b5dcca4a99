// Elements in all directions from one point: on a sphere around it, or the larger the farther away.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::scenes {
namespace {

struct Direction {
  double x;
  double y;
  double z;
};

/// A unit vector, each direction as often: a point at random in the unit ball, but near its middle.
Direction any_direction(Random& random) {
  while (true) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    const double z = random.uniform(-1.0, 1.0);
    const double square = x * x + y * y + z * z;
    if (square > 1.0 || square < 0.01) continue;
    const double length = std::sqrt(square);
    return {x / length, y / length, z / length};
  }
}

}  // namespace

/// On a sphere of radius R a cap of radius 2 is a part 1 / R^2 of it, so that each sphere of radius
/// 1 has N / (2 R^2) pairs.
Scene make_shell(std::size_t count, std::uint64_t seed) {
  const double distance = 0.5 * std::sqrt(static_cast<double>(count));
  Random random(seed);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const Direction to = any_direction(random);
    add_sphere(scene, distance * to.x, distance * to.y, distance * to.z, 1.0);
  }
  return scene;
}

/// Radii 1 + t at a distance proportional to t from 0 to 20, of a density C (1 + t)^-3: the same
/// number of pairs everywhere. The integral of t^2 (1 + t)^-3 is 1.6386, so that
///   C = N / (4 pi 1.6386)    pairs = C / 2 (4 pi / 3) (2 s)^3    with radii of s (1 + t)
/// and positions are divided by the s for two pairs each. t is drawn with a density of (1 + t)^-1
/// and taken with a chance of (t / (1 + t))^2.
Scene make_graded_by_place(std::size_t count, std::uint64_t seed) {
  constexpr double ends = 21.0;
  const double unit = cube_root(static_cast<double>(count + 1) / (1.5 * 1.6386));
  Random random(seed);
  Scene scene = empty_scene(3, count);
  while (scene.x.size() < count) {
    const double radius = fractional_power(ends, random.uniform());
    const double chance = (radius - 1.0) / radius;
    if (random.uniform() >= chance * chance) continue;
    const double distance = unit * (radius - 1.0);
    const Direction to = any_direction(random);
    add_sphere(scene, distance * to.x, distance * to.y, distance * to.z, radius);
  }
  return scene;
}

}  // namespace abut::scenes
