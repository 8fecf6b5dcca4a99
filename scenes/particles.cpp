// Particles of smoothed-particle hydrodynamics: each has many neighbours within its smoothing
// length.

#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::scenes {
namespace {

/// The smoothing length in spacings of the lattice is usually 1.2 or so, and kernels are zero
/// beyond two smoothing lengths.
constexpr double radius = 1.2;

/// Shaken particles are off their sites by at most so much on each axis.
constexpr double most_off = 0.2;

Scene sites(std::size_t count, double its_radius, double off, std::uint64_t seed) {
  const std::size_t side = side_of(count, 3);
  Random random(seed);
  const auto along = [&](std::size_t site) {
    return static_cast<double>(site) + off * random.uniform(-1.0, 1.0);
  };
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const double x = along(k % side);
    const double y = along(k / side % side);
    const double z = along(k / side / side);
    add_sphere(scene, x, y, z, its_radius);
  }
  shuffle(scene, seed);
  return scene;
}

}  // namespace

/// A simple cubic lattice, shaken: 29 pairs each.
Scene make_sph(std::size_t count, std::uint64_t seed) {
  return sites(count, radius, most_off, seed);
}

/// The lattice itself and a reach of two spacings: three of sixteen pairs each touch exactly.
Scene make_sph_lattice(std::size_t count, std::uint64_t seed) {
  return sites(count, 1.0, 0.0, seed);
}

}  // namespace abut::scenes
