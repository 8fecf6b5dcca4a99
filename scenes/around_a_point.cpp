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

/// Radii 1 + t at a distance proportional to t from 0 to T, of a density C (1 + t)^-3: the same
/// number of pairs everywhere. I is the integral of t^2 (1 + t)^-3, so that
///   C = N / (4 pi I)    pairs = C / 2 (4 pi / 3) (2 s)^3    with radii of s (1 + t)
/// and positions are divided by the s for two pairs each. t is drawn with a density of (1 + t)^-1
/// and taken with a chance of (t / (1 + t))^2.
Scene graded_by_place(std::size_t count, std::uint64_t seed, double largest, double integral) {
  const double unit = cube_root(static_cast<double>(count + 1) / (1.5 * integral));
  Random random(seed);
  Scene scene = empty_scene(3, count);
  while (scene.x.size() < count) {
    const double radius = fractional_power(largest, random.uniform());
    const double chance = (radius - 1.0) / radius;
    if (random.uniform() >= chance * chance) continue;
    const double distance = unit * (radius - 1.0);
    const Direction to = any_direction(random);
    add_sphere(scene, distance * to.x, distance * to.y, distance * to.z, radius);
  }
  return scene;
}

/// The ratio of the largest distance to the least where each decade of distances is as frequent.
constexpr double scales_of_crowds = 1e4;

}  // namespace

/// Each decade of distances from the point has the same number of spheres: a density of C r^-3 with
/// C = N / (4 pi ln(10^4)). With the least distance N^(1/3) / 6 spheres of radius 1 have a pair
/// each, at any N.
Scene make_crowds(std::size_t count, std::uint64_t seed) {
  const double least = cube_root(static_cast<double>(count + 1)) / 6.0;
  Random random(seed);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const double distance = least * fractional_power(scales_of_crowds, random.uniform());
    const Direction to = any_direction(random);
    add_sphere(scene, distance * to.x, distance * to.y, distance * to.z, 1.0);
  }
  return scene;
}

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

Scene make_graded_by_place(std::size_t count, std::uint64_t seed) {
  return graded_by_place(count, seed, 21.0, 1.6386);
}

Scene make_refined(std::size_t count, std::uint64_t seed) {
  return graded_by_place(count, seed, 13.0, 1.2158);
}

}  // namespace abut::scenes
