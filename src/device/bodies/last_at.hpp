#pragma once

#include "base/host_device.hpp"

#include <cstdint>

namespace abut::device {

/// The last of `count` ascending numbers, of which the first is 0, that is `item` or less: of what
/// begins at these items, the one to which an item belongs.
[[nodiscard]] ABUT_HD inline std::uint64_t last_at(const std::uint64_t* begins, std::uint64_t count,
                                                   std::uint64_t item) noexcept {
  std::uint64_t first = 0;
  while (count > 1) {
    const std::uint64_t half = count / 2;
    if (begins[first + half] <= item) {
      first += half;
      count -= half;
    } else {
      count = half;
    }
  }
  return first;
}

}  // namespace abut::device
