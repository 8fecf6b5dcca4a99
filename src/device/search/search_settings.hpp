#pragma once

#include "device/device_request.hpp"

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

  /// Larger elements that look into a level at a time; their numbers of items take 8 bytes each.
  [[nodiscard]] std::uint64_t coarse_at_a_time() const noexcept {
    return items_at_a_time > 1 ? items_at_a_time / 2 : 1;
  }
};

}  // namespace abut::device
