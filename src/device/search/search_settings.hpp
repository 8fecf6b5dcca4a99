#pragma once

#include "device/device_request.hpp"

#include <algorithm>
#include <cstdint>

namespace abut::device {

/// What a search is asked for, in the unit of its spheres.
struct SearchSettings {
  double margin;
  double slack;  ///< of distances
  std::uint64_t items_at_a_time = most_items_at_a_time;
  std::uint64_t narrow_places = most_narrow_places;

  /// Elements of a level whose places are counted together, from 0: nearly always 32 bits tell
  /// those of so many.
  [[nodiscard]] std::uint64_t elements_of_part() const noexcept { return 8 * items_at_a_time; }

  /// Larger elements that look into a level at a time, if each takes so many bytes besides.
  [[nodiscard]] std::uint64_t coarse_at_a_time(std::uint64_t bytes) const noexcept {
    return std::max<std::uint64_t>(bytes_of_coarse * items_at_a_time / bytes, 1);
  }

  static constexpr std::uint64_t bytes_of_coarse = 4;  ///< for each item
};

}  // namespace abut::device
