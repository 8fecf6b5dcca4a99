#pragma once

#include "base/host_device.hpp"

#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// All pairs of some elements and of each with itself, as numbers. The pairs of the first element
/// and of the last one together are as many as those of the second and the last but one, and so on:
/// rows of one length.
struct ElementPairs {
  std::uint64_t elements;  ///< fewer than 2^32

  [[nodiscard]] ABUT_HD std::uint64_t size() const noexcept {
    return elements % 2 == 0 ? elements / 2 * (elements + 1) : (elements + 1) / 2 * elements;
  }

  [[nodiscard]] ABUT_HD ContactPair at(std::uint64_t number) const noexcept {
    const std::uint64_t width = elements | 1;
    const std::uint64_t row = number / width;
    const std::uint64_t place = number % width;
    const std::uint64_t of_first = elements - row;
    if (place < of_first) return pair_of(row, row + place);
    const std::uint64_t last = elements - row - (width - elements);
    return pair_of(last, last + (place - of_first));
  }

 private:
  [[nodiscard]] ABUT_HD static ContactPair pair_of(std::uint64_t a, std::uint64_t b) noexcept {
    return {static_cast<ElementIndex>(a), static_cast<ElementIndex>(b)};
  }
};

}  // namespace abut::device
