#pragma once

#include "scenes/scene.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::testing {

/// A system and the margin to search it with.
struct CrowdedSystem {
  scenes::Scene scene;
  double margin = 0.0;
};

/// Random systems that send `rows` through its divisions: clouds, filaments, sheets and clouds
/// within clouds of very different widths, across the faces of any regular division of the box,
/// with radii from equal to spread over many decades, some on a lattice where touching is exact.
/// The same system from the same numbers everywhere.
[[nodiscard]] CrowdedSystem crowded_system(int dimensions, std::size_t count, std::uint64_t seed);

/// All lengths times 2^exponent, exactly: the same pairs.
[[nodiscard]] CrowdedSystem scaled(const CrowdedSystem& system, int exponent);

}  // namespace abut::testing
