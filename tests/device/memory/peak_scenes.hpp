#pragma once

#include "scenes/random.hpp"
#include "scenes/scene.hpp"

#include <abut/domain.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace abut::testing {

/// Elements so far apart that keys of cells have 64 bits, and no two pair: nothing hides what is
/// held for each.
[[nodiscard]] inline scenes::Scene strewn(std::size_t count, double side, int sizes) {
  scenes::Scene scene;
  scenes::Random random(9);
  for (std::size_t k = 0; k < count; ++k) {
    scene.x.push_back(random.uniform(0.0, side));
    scene.y.push_back(random.uniform(0.0, side));
    scene.z.push_back(random.uniform(0.0, side));
    scene.radius.push_back(std::ldexp(random.uniform(0.6, 1.0), static_cast<int>(k % 9) % sizes));
  }
  return scene;
}

[[nodiscard]] inline std::vector<scenes::Scene> compact_scenes(std::size_t count) {
  std::vector<scenes::Scene> all{strewn(4 * count, 1e4, 1), strewn(4 * count, 1e4, 9)};
  for (const char* const name : {"dense", "graded", "log_uniform_1000", "bidisperse", "one_giant",
                                 "touching_fcc", "graded_1000", "hexagonal_2d", "gas_2d"}) {
    all.push_back(scenes::scene_named(name).make(count, 5));
  }
  return all;
}

/// So far apart that each element is a stretch of its own on every axis, beside a compact part; of
/// one size, so that one level is all, and of nine, and with giants, which are a level of their
/// own.
[[nodiscard]] inline std::vector<scenes::Scene> wide_scenes(std::size_t count) {
  std::vector<scenes::Scene> all{strewn(count, 1e14, 1), strewn(count, 1e14, 9)};
  for (const std::size_t giants : {std::size_t{1}, std::size_t{7}}) {
    scenes::Scene scene = strewn(count, 1e14, 1);
    for (std::size_t k = 0; k < giants; ++k) scene.radius[count / 2 + k] = 1e13;
    all.push_back(scene);
  }
  for (const char* const name : {"two_far_clusters", "graded_1000", "log_uniform_1000"}) {
    scenes::Scene scene = scenes::scene_named(name).make(count, 5);
    for (std::size_t k = 0; k < count; k += 4) scene.x[k] += 1e13 * static_cast<double>(k);
    for (std::size_t k = 0; k < count; k += 3) scene.y[k] += 1e13 * static_cast<double>(k);
    for (std::size_t k = 0; k < scene.z.size(); k += 2) scene.z[k] += 1e13 * static_cast<double>(k);
    all.push_back(scene);
  }
  return all;
}

[[nodiscard]] inline double side_of(const scenes::Scene& scene) {
  return *std::max_element(scene.x.begin(), scene.x.end());
}

[[nodiscard]] inline Domain cell_of(const scenes::Scene& scene, double side) {
  return scene.dimensions == 2 ? Domain::periodic({side, side})
                               : Domain::periodic({side, side, side});
}

}  // namespace abut::testing
