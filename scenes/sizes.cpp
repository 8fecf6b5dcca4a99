// Elements of different sizes.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <array>
#include <cstdint>

namespace abut::scenes {
namespace {

/// Spheres with the radii that `draw` gives, at random in a cube of which they fill 0.3.
template <class Draw>
Scene filled_cube(std::size_t count, std::uint64_t seed, Draw draw) {
  constexpr double fraction = 0.3;
  Random random(seed);
  Scene scene = empty_scene(3, count);
  double cubes = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double radius = draw(random);
    scene.radius.push_back(radius);
    cubes += radius * radius * radius;
  }
  const double width = count == 0 ? 0.0 : cube_root(cubes * 4.0 * pi / (3.0 * fraction));
  for (std::size_t k = 0; k < count; ++k) {
    scene.x.push_back(random.uniform() * width);
    scene.y.push_back(random.uniform() * width);
    scene.z.push_back(random.uniform() * width);
  }
  return scene;
}

Scene log_uniform(std::size_t count, std::uint64_t seed, double largest) {
  return filled_cube(count, seed, [largest](Random& random) {
    return fractional_power(largest, random.uniform());
  });
}

/// Number density as r^-4 on 1..R, `smallest_share` being R^-3: the same solid volume in every
/// decade. The distribution (1 - r^-3) / (1 - R^-3), inverted.
Scene graded(std::size_t count, std::uint64_t seed, double smallest_share) {
  return filled_cube(count, seed, [smallest_share](Random& random) {
    return 1.0 / cube_root(1.0 - random.uniform() * (1.0 - smallest_share));
  });
}

}  // namespace

Scene make_bidisperse(std::size_t count, std::uint64_t seed) {
  return filled_cube(count, seed,
                     [](Random& random) { return random.uniform() < 0.01 ? 10.0 : 1.0; });
}

/// As sieved grains are.
Scene make_polydisperse(std::size_t count, std::uint64_t seed) {
  return filled_cube(count, seed, [](Random& random) { return random.uniform(1.0, 4.0); });
}

Scene make_log_uniform(std::size_t count, std::uint64_t seed) {
  return log_uniform(count, seed, 100.0);
}

Scene make_log_uniform_1000(std::size_t count, std::uint64_t seed) {
  return log_uniform(count, seed, 1000.0);
}

Scene make_graded(std::size_t count, std::uint64_t seed) {
  return graded(count, seed, 1e-6);
}

Scene make_graded_1000(std::size_t count, std::uint64_t seed) {
  return graded(count, seed, 1e-9);
}

/// The last element is as large as the gas of small ones and dips into one side of it.
Scene make_one_giant(std::size_t count, std::uint64_t seed) {
  if (count == 0) return empty_scene(3, 0);
  Scene scene = make_gas(count - 1, seed);
  const double width = count == 1 ? 1.0 : cube_root(static_cast<double>(count) * 80.0);
  add_sphere(scene, -0.95 * width, 0.5 * width, 0.5 * width, width);
  return scene;
}

}  // namespace abut::scenes
