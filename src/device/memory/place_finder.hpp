#pragma once

#include "device/memory/block_sequence.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace abut::device {

/// Places blocks of a call one by one, each at the lowest place that no block before it has at the
/// same time.
class PlaceFinder {
 public:
  /// The blocks, of which the first ones have their places.
  PlaceFinder(std::vector<PlacedBlock>& blocks, std::size_t placed)
      : blocks_(blocks), placed_(placed) {}

  /// Places those with these numbers, in this order, and returns the length of the array; any that
  /// is not shorter than a limit where it would be.
  std::uint64_t place(std::span<const std::size_t> order,
                      std::uint64_t limit = std::numeric_limits<std::uint64_t>::max());
  /// How many it placed below the limit.
  [[nodiscard]] std::size_t placed_count() const noexcept { return by_place_.size(); }

 private:
  [[nodiscard]] std::uint64_t lowest_place(const PlacedBlock& block) const noexcept;

  std::vector<PlacedBlock>& blocks_;
  std::size_t placed_;
  std::vector<PlacedBlock> by_place_;  ///< those that are placed
};

}  // namespace abut::device
