#include "benchmarks/systems/two_scenes.hpp"

#include "scenes/random.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace abut::benchmarks {
namespace {

using scenes::Scene;

void append(Scene& scene, const Scene& from, std::size_t k) {
  scene.x.push_back(from.x[k]);
  scene.y.push_back(from.y[k]);
  scene.z.push_back(from.z[k]);
  scene.radius.push_back(from.radius[k]);
}

Scene joined(Scene first, const Scene& second) {
  for (std::size_t k = 0; k < second.size(); ++k) append(first, second, k);
  return first;
}

TwoScenes named(const char* name, Scene first, Scene second) {
  Scene both = joined(first, second);
  return {name, std::move(first), std::move(second), std::move(both)};
}

/// Elements for which is_first(k) is true, and the others.
template <class IsFirst>
TwoScenes divided(const char* name, const Scene& scene, IsFirst is_first) {
  Scene first;
  Scene second;
  for (std::size_t k = 0; k < scene.size(); ++k) append(is_first(k) ? first : second, scene, k);
  return named(name, std::move(first), std::move(second));
}

double largest(const std::vector<double>& column) {
  return column.empty() ? 0.0 : *std::max_element(column.begin(), column.end());
}

}  // namespace

TwoScenes probes_in(const Scene& scene) {
  scenes::Random random(5);
  const double side[] = {largest(scene.x), largest(scene.y), largest(scene.z)};
  Scene probes;
  for (std::size_t k = 0; k < scene.size() / 100; ++k) {
    probes.x.push_back(random.uniform(0.0, side[0]));
    probes.y.push_back(random.uniform(0.0, side[1]));
    probes.z.push_back(random.uniform(0.0, side[2]));
    probes.radius.push_back(0.0);
  }
  return named("probes", std::move(probes), scene);
}

TwoScenes slab_against_rest(const Scene& scene) {
  const double top = 0.1 * largest(scene.z);
  return divided("slab", scene, [&](std::size_t k) { return scene.z[k] < top; });
}

TwoScenes every_other(const Scene& scene) {
  return divided("every other", scene, [](std::size_t k) { return k % 2 == 0; });
}

TwoScenes far_apart(const Scene& scene) {
  Scene beside = scene;
  const double way = largest(scene.x) + 4.0 * largest(scene.radius);
  for (double& x : beside.x) x += way;
  return named("far apart", scene, std::move(beside));
}

}  // namespace abut::benchmarks
