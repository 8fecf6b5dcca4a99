// The most bytes that a detection holds, in each kind of domain and of each kind of elements: 64
// for each element and each ghost and 16 for each pair, or less.

#include "device/host_detection.hpp"
#include "device/scene_in_two.hpp"
#include "scenes/box_scene.hpp"
#include "scenes/random.hpp"
#include "support/box_oracle.hpp"
#include "support/scene_view.hpp"

#include <abut/device.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// What does not follow the number of elements where 100 items are counted at a time.
constexpr std::uint64_t fixed = 8192;

/// Expects no more bytes than that for an element or a ghost, whatever is asked for.
void expect_at_most(std::uint64_t bytes, const ElementView& elements, HostRun run) {
  run.items_at_a_time = 100;
  for (const device::ListForm form : {device::ListForm::pairs, device::ListForm::full_rows}) {
    run.form = form;
    const HostAnswer list = list_on_host(elements, 0.0, run);
    const std::uint64_t entries = std::max<std::uint64_t>(list.count, list.neighbors.size());
    const std::uint64_t pairs = entries + list.exact_decisions;
    EXPECT_LE(list.peak_bytes, bytes * list.searched + 16 * pairs + fixed)
        << "pairs apart " << (list.peak_bytes - 16 * pairs) / list.searched << " an element";
  }
  const HostAnswer count = count_on_host(elements, 0.0, run);
  EXPECT_LE(count.peak_bytes, bytes * count.searched + 16 * count.exact_decisions + fixed)
      << count.peak_bytes / count.searched << " an element";
}

/// Of spheres, of boxes and of two sets.
void expect_at_most(std::uint64_t bytes, const Scene& scene, const Domain& domain) {
  expect_at_most(bytes, view_of(scene), {.domain = domain});
  const scenes::BoxScene boxes = scenes::boxes_in(scene, 6);
  expect_at_most(bytes, view_of(boxes), {.domain = domain});
  const SceneInTwo sets(scene);
  const ElementView second = view_of(sets.second);
  expect_at_most(bytes, view_of(sets.first), {.domain = domain, .second = &second});
}

/// Elements so far apart that keys of cells have 64 bits, and no two pair: nothing hides what is
/// held for each.
Scene strewn(std::size_t count, double side, int sizes) {
  Scene scene;
  scenes::Random random(9);
  for (std::size_t k = 0; k < count; ++k) {
    scene.x.push_back(random.uniform(0.0, side));
    scene.y.push_back(random.uniform(0.0, side));
    scene.z.push_back(random.uniform(0.0, side));
    scene.radius.push_back(std::ldexp(random.uniform(0.6, 1.0), static_cast<int>(k % 9) % sizes));
  }
  return scene;
}

std::vector<Scene> compact_scenes(std::size_t count) {
  std::vector<Scene> all{strewn(count, 1e4, 1), strewn(count, 1e4, 9)};
  for (const char* const name : {"dense", "graded", "log_uniform_1000", "bidisperse", "one_giant",
                                 "touching_fcc", "graded_1000", "hexagonal_2d", "gas_2d"}) {
    all.push_back(scenes::scene_named(name).make(count, 5));
  }
  return all;
}

TEST(DevicePeak, InACompactDomain) {
  for (const Scene& scene : compact_scenes(4000)) expect_at_most(48, scene, Domain::open());
}

double side_of(const Scene& scene) {
  return *std::max_element(scene.x.begin(), scene.x.end());
}

Domain cell_of(const Scene& scene, double side) {
  return scene.dimensions == 2 ? Domain::periodic({side, side})
                               : Domain::periodic({side, side, side});
}

/// As given, and with elements some cells out, which are moved; ghosts are few and many.
TEST(DevicePeak, InAPeriodicDomain) {
  for (const std::size_t count : {std::size_t{300}, std::size_t{3000}}) {
    for (Scene& scene : compact_scenes(count)) {
      const double side = side_of(scene);
      const Domain cell = cell_of(scene, side);
      expect_at_most(64, scene, cell);
      for (std::size_t k = 0; k < count; k += 2) scene.x[k] += 3.0 * side;
      expect_at_most(64, scene, cell);
    }
  }
}

/// So far apart that each element is a stretch of its own on every axis, beside a compact part; of
/// one size, so that one level is all, and of nine, and with giants, which are a level of their
/// own.
std::vector<Scene> wide_scenes(std::size_t count) {
  std::vector<Scene> all{strewn(count, 1e14, 1), strewn(count, 1e14, 9)};
  for (const std::size_t giants : {std::size_t{1}, std::size_t{7}}) {
    Scene scene = strewn(count, 1e14, 1);
    for (std::size_t k = 0; k < giants; ++k) scene.radius[count / 2 + k] = 1e13;
    all.push_back(scene);
  }
  for (const char* const name : {"two_far_clusters", "graded_1000", "log_uniform_1000"}) {
    Scene scene = scenes::scene_named(name).make(count, 5);
    for (std::size_t k = 0; k < count; k += 4) scene.x[k] += 1e13 * static_cast<double>(k);
    for (std::size_t k = 0; k < count; k += 3) scene.y[k] += 1e13 * static_cast<double>(k);
    for (std::size_t k = 0; k < scene.z.size(); k += 2) scene.z[k] += 1e13 * static_cast<double>(k);
    all.push_back(scene);
  }
  return all;
}

TEST(DevicePeak, InAWideDomain) {
  for (const std::size_t count : {std::size_t{400}, std::size_t{4000}}) {
    for (const Scene& scene : wide_scenes(count)) expect_at_most(60, scene, Domain::open());
  }
}

/// Wide along open axes, with a periodic face; and wide in a cell that is as wide.
TEST(DevicePeak, InAWidePeriodicDomain) {
  for (const Scene& scene : wide_scenes(3000)) {
    const double side = side_of(scene);
    for (const double length : {0.25 * side, side}) {
      expect_at_most(76, scene, Domain::periodic({length, unbounded, unbounded}));
      expect_at_most(76, scene, Domain::periodic({length, length, length}));
    }
  }
}

}  // namespace
}  // namespace abut::testing
