#include "scenes/families.hpp"

#include "scenes/random.hpp"

#include <abut/error.hpp>

#include <limits>
#include <new>
#include <string>
#include <utility>

#include <unistd.h>

namespace abut::scenes {
namespace {

/// Element numbers are 32-bit everywhere, and 2^32 - 1 is kept free.
constexpr std::size_t most_elements = std::numeric_limits<std::uint32_t>::max() - 1;

[[noreturn]] void refuse(std::size_t count) {
  throw Error(ErrorCode::limit_exceeded,
              "a scene of " + std::to_string(count) +
                  " elements does not fit into memory; ask for fewer elements");
}

/// Tells whether a scene exceeds the memory of the machine: where memory is promised without being
/// there, reserving it does not fail.
bool exceeds_machine(double bytes) {
  const auto pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const auto page_size = static_cast<double>(sysconf(_SC_PAGESIZE));
  return pages > 0.0 && page_size > 0.0 && bytes > pages * page_size;
}

}  // namespace

void require_possible(std::size_t count) {
  constexpr double bytes_per_element = 4.0 * sizeof(double);
  if (count > most_elements || exceeds_machine(static_cast<double>(count) * bytes_per_element)) {
    refuse(count);
  }
}

Scene empty_scene(int dimensions, std::size_t count) {
  require_possible(count);
  Scene scene;
  scene.dimensions = dimensions;
  try {
    scene.x.reserve(count);
    scene.y.reserve(count);
    if (dimensions == 3) scene.z.reserve(count);
    scene.radius.reserve(count);
  } catch (const std::bad_alloc&) {
    refuse(count);
  }
  return scene;
}

void add_disc(Scene& scene, double x, double y, double radius) {
  scene.x.push_back(x);
  scene.y.push_back(y);
  scene.radius.push_back(radius);
}

void add_sphere(Scene& scene, double x, double y, double z, double radius) {
  add_disc(scene, x, y, radius);
  scene.z.push_back(z);
}

void shuffle(Scene& scene, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t left = scene.size(); left > 1; --left) {
    const std::size_t k = random.below(left);
    std::swap(scene.x[left - 1], scene.x[k]);
    std::swap(scene.y[left - 1], scene.y[k]);
    if (scene.dimensions == 3) std::swap(scene.z[left - 1], scene.z[k]);
    std::swap(scene.radius[left - 1], scene.radius[k]);
  }
}

Scene reordered(const Scene& scene, const std::vector<std::size_t>& order) {
  Scene result = empty_scene(scene.dimensions, scene.size());
  for (const std::size_t k : order) {
    add_disc(result, scene.x[k], scene.y[k], scene.radius[k]);
    if (scene.dimensions == 3) result.z.push_back(scene.z[k]);
  }
  return result;
}

std::size_t side_of(std::size_t count, int dimensions) {
  std::size_t side = 0;
  while ((dimensions == 2 ? side * side : side * side * side) < count) ++side;
  return side;
}

}  // namespace abut::scenes
