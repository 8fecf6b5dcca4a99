#pragma once

#include "scenes/scene.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::scenes {

/// Axis-aligned boxes, by axis; in 2D the third is empty.
struct BoxScene {
  int dimensions = 3;
  std::array<std::vector<double>, 3> lower;
  std::array<std::vector<double>, 3> upper;

  [[nodiscard]] std::size_t size() const noexcept { return lower[0].size(); }
};

/// A box in each element: round its center, on each axis 0.2 to 1 of its diameter wide.
[[nodiscard]] BoxScene boxes_in(const Scene& scene, std::uint64_t seed);

}  // namespace abut::scenes
