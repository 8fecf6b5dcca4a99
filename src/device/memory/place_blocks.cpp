#include "device/memory/place_blocks.hpp"

#include "device/memory/block_places.hpp"
#include "device/memory/order_search.hpp"
#include "device/memory/place_finder.hpp"

#include <algorithm>
#include <numeric>
#include <span>

namespace abut::device {
namespace {

/// More are placed as they come, in a time that follows their number and not its square.
constexpr std::size_t most_in_other_orders = 512;

/// An array that is longer than what is held by this part of it is short enough.
constexpr std::uint64_t part_of_held = 1024;

/// Calls take(k) and give_back(k) for the blocks in the order of their steps.
void for_each_step(const std::vector<PlacedBlock>& blocks, const auto& take,
                   const auto& give_back) {
  std::vector<std::size_t> by_end(blocks.size());
  std::iota(by_end.begin(), by_end.end(), std::size_t{0});
  std::sort(by_end.begin(), by_end.end(),
            [&](std::size_t a, std::size_t b) { return blocks[a].end < blocks[b].end; });
  auto next_end = by_end.begin();
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    for (; blocks[*next_end].end < blocks[k].begin; ++next_end) give_back(*next_end);
    take(k);
  }
}

/// As the executor would take them, each at the lowest gap.
std::uint64_t place_as_they_come(std::vector<PlacedBlock>& blocks, std::size_t placed) {
  BlockPlaces places;
  for_each_step(
      blocks,
      [&](std::size_t k) {
        if (k >= placed) blocks[k].place = places.lowest_gap(blocks[k].bytes);
        places.take(blocks[k].place, blocks[k].bytes);
      },
      [&](std::size_t k) { places.give_back(blocks[k].place); });
  return places.length();
}

}  // namespace

std::uint64_t most_held_at_once(const std::vector<PlacedBlock>& blocks) {
  std::uint64_t held = 0;
  std::uint64_t most = 0;
  for_each_step(
      blocks, [&](std::size_t k) { most = std::max(most, held += blocks[k].bytes); },
      [&](std::size_t k) { held -= blocks[k].bytes; });
  return most;
}

std::uint64_t place_blocks(std::vector<PlacedBlock>& blocks, std::size_t placed,
                           std::uint64_t good) {
  const std::uint64_t length = place_as_they_come(blocks, placed);
  const std::uint64_t held = most_held_at_once(blocks);
  const std::uint64_t short_enough = std::max(good, held + held / part_of_held);
  if (length <= short_enough || blocks.size() > most_in_other_orders) return length;
  return OrderSearch(blocks, placed, length, held).run(short_enough);
}

}  // namespace abut::device
