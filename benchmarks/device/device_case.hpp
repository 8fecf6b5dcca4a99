#pragma once

#include "benchmarks/device/device_row.hpp"

#include <cstdint>
#include <string_view>

namespace abut::benchmarks {

/// Measures the processor, the device and, in 3D, a plain grid on a scene, and prints a row each.
/// False if the device's digest was another than the processor's.
bool measure_scene(std::string_view name, std::uint64_t elements, const DeviceEffort& effort);

/// Finds the pairs of so many copies of a scene side by side, for more elements than the processor
/// has time for: their number must be that of the copies. False if it is not.
bool measure_copies(std::string_view name, std::uint64_t elements, std::uint32_t copies,
                    const DeviceEffort& effort);

}  // namespace abut::benchmarks
