// Elements at random places, far from dense.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cmath>
#include <cstdint>

namespace abut::scenes {
namespace {

constexpr double gas_fraction = 0.05;

Scene spheres_in_cube(std::size_t count, double width, std::uint64_t seed) {
  Random random(seed);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = random.uniform() * width;
    const double y = random.uniform() * width;
    const double z = random.uniform() * width;
    add_sphere(scene, x, y, z, 1.0);
  }
  return scene;
}

}  // namespace

Scene make_gas_2d(std::size_t count, std::uint64_t seed) {
  const double width = std::sqrt(static_cast<double>(count) * pi / gas_fraction);
  Random random(seed);
  Scene scene = empty_scene(2, count);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = random.uniform() * width;
    const double y = random.uniform() * width;
    add_disc(scene, x, y, 1.0);
  }
  return scene;
}

Scene make_gas(std::size_t count, std::uint64_t seed) {
  const double volume = static_cast<double>(count) * 4.0 * pi / (3.0 * gas_fraction);
  return spheres_in_cube(count, count == 0 ? 0.0 : cube_root(volume), seed);
}

Scene make_sparse(std::size_t count, std::uint64_t seed) {
  return spheres_in_cube(count, 1e5, seed);
}

}  // namespace abut::scenes
