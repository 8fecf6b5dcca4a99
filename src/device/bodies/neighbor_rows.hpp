#pragma once

#include "base/host_device.hpp"
#include "base/opposite_shift.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// Body: writes pair k once more behind all pairs, as its second element sees it.
struct ReversePair {
  ContactPair* pairs;
  ImageShift* shifts;   ///< null where nobody asks for them
  std::uint64_t count;  ///< of the pairs; there is room for as many

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    pairs[count + k] = {pairs[k].second, pairs[k].first};
    if (shifts != nullptr) shifts[count + k] = base::opposite(shifts[k]);
  }
};

/// Body: where row k begins among pairs in order, the first of those whose first element is k or
/// more; behind the last row, how many pairs there are.
struct RowOffset {
  const ContactPair* pairs;
  std::uint64_t count;
  PairCount* offsets;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    std::uint64_t first = 0;
    std::uint64_t end = count;
    while (first < end) {
      const std::uint64_t middle = first + (end - first) / 2;
      if (pairs[middle].first < k) {
        first = middle + 1;
      } else {
        end = middle;
      }
    }
    offsets[k] = first;
  }
};

/// Body: the neighbor that pair k stands for in the row of its first element.
struct NeighborOfPair {
  const ContactPair* pairs;
  ElementIndex* neighbors;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { neighbors[k] = pairs[k].second; }
};

}  // namespace abut::device
