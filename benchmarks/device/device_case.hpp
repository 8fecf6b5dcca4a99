#pragma once

#include "scenes/scene.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace abut::benchmarks {

/// One row of the table: a contestant on a scene. Times in seconds of one detection.
struct DeviceRow {
  std::string contestant;
  std::string scene;
  std::uint64_t elements = 0;
  std::uint64_t pairs = 0;  ///< that this contestant found
  bool is_right = true;     ///< the digest of the processor; others are not timed
  double first = 0.0;       ///< the first call, which takes the memory
  double median = 0.0;
  double least = 0.0;
  double gather = 0.0;  ///< by events: check, frame
  double search = 0.0;  ///< place, sort, count, write, decide
  double order = 0.0;
  std::uint64_t peak_bytes = 0;
  double bytes_of_element = 0.0;  ///< that the pipeline moves, by docs of the design
};

struct DeviceEffort {
  int calls = 7;            ///< after the first
  double copy_speed = 0.0;  ///< bytes a second, of the ceilings
};

/// Prints the heading of the table, and its rows.
void print_heading();
void print_row(const DeviceRow& row, const DeviceEffort& effort, double processor_seconds);

/// Measures the processor, the device and, in 3D, a plain grid on a scene, and prints a row each.
/// False if the device's digest was another than the processor's.
bool measure_scene(std::string_view name, std::uint64_t elements, const DeviceEffort& effort);

/// Finds the pairs of so many copies of a scene side by side, for more elements than the processor
/// has time for: their number must be that of the copies. False if it is not.
bool measure_copies(std::string_view name, std::uint64_t elements, std::uint32_t copies,
                    const DeviceEffort& effort);

}  // namespace abut::benchmarks
