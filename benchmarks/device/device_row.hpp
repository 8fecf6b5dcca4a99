#pragma once

#include <cstdint>
#include <optional>
#include <string>

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
  double compulsory_bytes = 1.0;      ///< see list_bytes.hpp
  std::optional<double> moved_bytes;  ///< of the device engine, where they are known
};

struct DeviceEffort {
  int calls = 7;            ///< after the first
  double copy_speed = 0.0;  ///< bytes a second, of the ceilings
};

/// Prints the heading of the table, and its rows.
void print_heading();
void print_row(const DeviceRow& row, const DeviceEffort& effort, double processor_seconds);

}  // namespace abut::benchmarks
