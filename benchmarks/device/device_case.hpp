#pragma once

#include "benchmarks/device/device_row.hpp"

#include <cstdint>
#include <string_view>

namespace abut::benchmarks {

struct SceneCase {
  std::string_view scene;
  std::uint64_t elements = 0;
  double margin = 0.0;
};

/// Measures the processor, the device and, in 3D, a plain grid on a scene, and prints a row each.
/// False if the device's digest was another than the processor's.
bool measure_scene(const SceneCase& what, const DeviceEffort& effort);

/// Finds the pairs of so many copies of a scene of equal spheres side by side, for more elements
/// than the processor has time for, and counts those within the margin, of which there may be more
/// than the device has memory for. Their numbers must be those of the copies; false if they are
/// not.
bool measure_copies(const SceneCase& what, std::uint32_t copies, const DeviceEffort& effort);

}  // namespace abut::benchmarks
