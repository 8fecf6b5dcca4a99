#pragma once

#include "device/memory/block_places.hpp"
#include "device/memory/block_sequence.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::device {

/// Where the blocks of a call lie in one array that is hardly longer than what they hold at once.
class BlockPlan {
 public:
  /// Of blocks that have places in an array of that length.
  BlockPlan(std::vector<PlacedBlock> blocks, std::uint64_t length);

  [[nodiscard]] const std::vector<PlacedBlock>& blocks() const noexcept { return blocks_; }
  [[nodiscard]] std::uint64_t length() const noexcept { return length_; }

  /// True if a call took and gave back its blocks in the steps that are planned.
  [[nodiscard]] bool has_steps_of(const std::vector<PlacedBlock>& blocks) const noexcept;

  /// True if it did, and if none was larger than planned.
  [[nodiscard]] bool has_room_for(const std::vector<PlacedBlock>& blocks) const noexcept;

  /// True if a call has so far taken blocks that are planned, where they are planned; the last one
  /// has no place yet.
  [[nodiscard]] bool begins_as(const std::vector<PlacedBlock>& taken) const noexcept;

  /// Finds the lowest gap without places of blocks from the next one on that are expected before a
  /// step: what lies there would rob larger blocks of places that hardly any others are as long as.
  [[nodiscard]] std::uint64_t gap_beside(std::size_t next, std::uint64_t before,
                                         std::uint64_t bytes,
                                         const BlockPlaces& taken) const noexcept;

 private:
  std::vector<PlacedBlock> blocks_;
  std::vector<std::size_t> by_place_;  ///< numbers of the blocks
  std::uint64_t length_;
};

}  // namespace abut::device
