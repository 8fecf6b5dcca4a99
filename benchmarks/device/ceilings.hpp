#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace abut::benchmarks {

/// What the device does at best, without any search: the measure for all that follows.
struct Ceiling {
  std::string name;
  std::uint64_t items = 0;
  double seconds = 0.0;
  double bytes_of_item = 0.0;  ///< read and written, at least
};

/// Measures what the host takes for a launch and a wait, whatever the items: empty kernels, copies
/// of a few bytes, and chains of launches as those of a detection. One item each, of no bytes.
[[nodiscard]] std::vector<Ceiling> measure_latencies();

/// Measures copies, sorts, scans and gathers of so many items.
[[nodiscard]] std::vector<Ceiling> measure_ceilings(std::uint64_t items);

/// Bytes a second, those that are read and those that are written, of a long copy.
[[nodiscard]] double copy_speed();

}  // namespace abut::benchmarks
