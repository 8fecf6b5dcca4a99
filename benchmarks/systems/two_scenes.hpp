#pragma once

#include "scenes/scene.hpp"

#include <string>

namespace abut::benchmarks {

/// Two sets to be searched against each other.
struct TwoScenes {
  std::string name;
  scenes::Scene first;
  scenes::Scene second;
  scenes::Scene both;  ///< the second behind the first
};

/// Points at random places among the elements, one for a hundred.
[[nodiscard]] TwoScenes probes_in(const scenes::Scene& scene);
/// The lowest tenth of the box, as an active part, against what lies above.
[[nodiscard]] TwoScenes slab_against_rest(const scenes::Scene& scene);
/// Elements of even and of odd number.
[[nodiscard]] TwoScenes every_other(const scenes::Scene& scene);
/// The scene and its copy beside it, which touch nowhere.
[[nodiscard]] TwoScenes far_apart(const scenes::Scene& scene);

}  // namespace abut::benchmarks
