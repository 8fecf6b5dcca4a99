// Elements that crowd in a few places of a wide domain.

#include "scenes/arithmetic.hpp"
#include "scenes/families.hpp"
#include "scenes/random.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace abut::scenes {
namespace {

/// Standard deviation of a Gaussian cluster of `size` spheres of radius 1 that gives each about
/// three pairs. The difference of two centres has variance 2 s^2 an axis, hence density
/// (4 pi s^2)^(-3/2) near 0, and the sphere of radius 2 a share of (32 pi / 3) of it:
///   3 = (size / 2) (32 pi / 3) / (4 pi s^2)^(3/2)
/// In a small cluster the density falls within the reach: of 100 it has 2.6 pairs each, of 30 2.2.
double spread(double size) {
  constexpr double four_pi_to_three_halves = 44.546623974653656;
  return cube_root(size * 16.0 * pi / (9.0 * four_pi_to_three_halves));
}

/// Clusters of about `size` elements; ten clusters, where that would make fewer.
Scene clusters_of(std::size_t size, std::size_t count, std::uint64_t seed) {
  constexpr double width = 1e6;
  const std::size_t cluster_count = std::max<std::size_t>(10, count / size);
  const double deviation =
      spread(std::max(1.0, static_cast<double>(count) / static_cast<double>(cluster_count)));
  Random random(seed);
  Scene middles = empty_scene(3, cluster_count);
  for (std::size_t k = 0; k < cluster_count; ++k) {
    const double x = random.uniform() * width;
    const double y = random.uniform() * width;
    add_sphere(middles, x, y, random.uniform() * width, 0.0);
  }
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t cluster = k % cluster_count;
    const double x = middles.x[cluster] + deviation * random.gaussian();
    const double y = middles.y[cluster] + deviation * random.gaussian();
    const double z = middles.z[cluster] + deviation * random.gaussian();
    add_sphere(scene, x, y, z, 1.0);
  }
  return scene;
}

}  // namespace

Scene make_clusters(std::size_t count, std::uint64_t seed) {
  return clusters_of(1000, count, seed);
}

Scene make_clusters_100(std::size_t count, std::uint64_t seed) {
  return clusters_of(100, count, seed);
}

Scene make_clusters_30(std::size_t count, std::uint64_t seed) {
  return clusters_of(30, count, seed);
}

/// Makes two clusters 10^18 apart, where neighbouring doubles are 128 apart: radii of 100 still
/// touch there.
Scene make_two_far_clusters(std::size_t count, std::uint64_t seed) {
  constexpr double distance = 1e18;
  const double width = 400.0 * cube_root(static_cast<double>(count) + 1.0);
  Random random(seed);
  Scene scene = empty_scene(3, count);
  for (std::size_t k = 0; k < count; ++k) {
    const double offset = k % 2 == 0 ? 0.0 : distance;
    const double x = offset + random.uniform() * width;
    const double y = offset + random.uniform() * width;
    const double z = offset + random.uniform() * width;
    add_sphere(scene, x, y, z, 100.0);
  }
  return scene;
}

}  // namespace abut::scenes
