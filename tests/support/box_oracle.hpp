#pragma once

#include "scenes/box_scene.hpp"
#include "support/oracle.hpp"

#include <abut/element_view.hpp>

#include <tuple>

/// The contract for boxes, computed without any of the library: all pairs, rational arithmetic.
namespace abut::testing {

[[nodiscard]] inline ElementView view_of(const scenes::BoxScene& scene) {
  const auto& [lower, upper] = std::tie(scene.lower, scene.upper);
  return scene.dimensions == 2 ? rectangles(lower[0], lower[1], upper[0], upper[1])
                               : boxes(lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]);
}

/// All contact pairs, in canonical order. Differences far from the margin are compared in double,
/// the others in rational numbers.
[[nodiscard]] PairVector oracle_pairs(const scenes::BoxScene& scene, double margin = 0.0);

}  // namespace abut::testing
