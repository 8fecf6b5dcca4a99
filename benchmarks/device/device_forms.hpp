#pragma once

#include "benchmarks/device/device_row.hpp"

#include <cstdint>
#include <string_view>

namespace abut::benchmarks {

/// Measures other results than pairs in open space, on the processor and on the device: gaps,
/// neighbor lists, pairs of a periodic block with and without shifts. Prints two rows for each, and
/// is false if the device found something else than the processor.
bool measure_forms(std::string_view name, std::uint64_t elements, const DeviceEffort& effort);

}  // namespace abut::benchmarks
