#pragma once

#include <cstdint>
#include <limits>

namespace abut::device {

/// Items of a search between levels that are counted at a time; their counts take 16 bytes each.
inline constexpr std::uint64_t most_items_at_a_time = std::uint64_t{1} << 21;

/// What a detection on a device is asked for.
struct DeviceRequest {
  double margin = 0.0;
  std::uint64_t max_pairs = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t items_at_a_time = most_items_at_a_time;
};

}  // namespace abut::device
