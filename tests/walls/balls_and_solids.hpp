#pragma once

#include <abut/element_view.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace abut::testing {

/// Spheres and boxes as a caller has them; in 2D the third of each is empty.
struct BallsAndSolids {
  using Columns = std::array<std::vector<double>, 3>;

  int dimensions;
  Columns center;
  Columns lower;
  Columns upper;
  std::vector<double> radius;

  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(dimensions); }
  [[nodiscard]] ElementView balls() const {
    return dimensions == 2 ? discs(center[0], center[1], radius)
                           : spheres(center[0], center[1], center[2], radius);
  }
  [[nodiscard]] ElementView solids() const {
    return dimensions == 2 ? rectangles(lower[0], lower[1], upper[0], upper[1])
                           : boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
  }
};

}  // namespace abut::testing
