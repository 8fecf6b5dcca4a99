#pragma once

#include "scenes/scene.hpp"
#include "support/scene_view.hpp"

#include <cstddef>
#include <vector>

namespace abut::testing {

/// The elements of a scene in two sets, two of three in the second one.
struct SceneInTwo {
  scenes::Scene first;
  scenes::Scene second;

  explicit SceneInTwo(const scenes::Scene& scene) {
    std::vector<std::size_t> numbers[2];
    for (std::size_t k = 0; k < scene.size(); ++k) numbers[k % 3 == 0 ? 0 : 1].push_back(k);
    first = part_of(scene, numbers[0]);
    second = part_of(scene, numbers[1]);
  }
};

}  // namespace abut::testing
