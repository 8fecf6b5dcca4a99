#pragma once

#include "device/memory/block_sequence.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::device {

/// Most bytes that the blocks of a call hold at once: no array for all of them is shorter.
[[nodiscard]] std::uint64_t most_held_at_once(const std::vector<PlacedBlock>& blocks);

/// Gives the blocks of a call, which stand in the order of their steps, places in one array, so
/// that none overlap which are there at the same time; the first ones may have places already.
/// Returns the length of the array. An array of the length `good` is short enough, whatever the
/// blocks hold.
[[nodiscard]] std::uint64_t place_blocks(std::vector<PlacedBlock>& blocks, std::size_t placed = 0,
                                         std::uint64_t good = 0);

}  // namespace abut::device
