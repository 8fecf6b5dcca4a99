#include "device/memory/block_plan.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace abut::device {
namespace {

/// Plans of more blocks are followed without looking at what comes.
constexpr std::size_t most_looked_through = 512;

bool begins_alike(const PlacedBlock& planned, const PlacedBlock& block) {
  return planned.begin == block.begin && planned.bytes >= block.bytes;
}

}  // namespace

BlockPlan::BlockPlan(std::vector<PlacedBlock> blocks, std::uint64_t length)
    : blocks_(std::move(blocks)), by_place_(blocks_.size()), length_(length) {
  std::iota(by_place_.begin(), by_place_.end(), std::size_t{0});
  std::sort(by_place_.begin(), by_place_.end(),
            [this](std::size_t a, std::size_t b) { return blocks_[a].place < blocks_[b].place; });
}

bool BlockPlan::has_steps_of(const std::vector<PlacedBlock>& blocks) const noexcept {
  return std::equal(blocks_.begin(), blocks_.end(), blocks.begin(), blocks.end(),
                    [](const PlacedBlock& planned, const PlacedBlock& block) {
                      return planned.begin == block.begin && planned.end == block.end;
                    });
}

bool BlockPlan::has_room_for(const std::vector<PlacedBlock>& blocks) const noexcept {
  return has_steps_of(blocks) &&
         std::equal(blocks_.begin(), blocks_.end(), blocks.begin(), blocks.end(), begins_alike);
}

bool BlockPlan::begins_as(const std::vector<PlacedBlock>& taken) const noexcept {
  if (taken.size() > blocks_.size()) return false;
  const auto last = taken.end() - 1;
  return begins_alike(blocks_[taken.size() - 1], *last) &&
         std::equal(taken.begin(), last, blocks_.begin(),
                    [](const PlacedBlock& block, const PlacedBlock& planned) {
                      return begins_alike(planned, block) && planned.place == block.place;
                    });
}

std::uint64_t BlockPlan::gap_beside(std::size_t next, std::uint64_t before, std::uint64_t bytes,
                                    const BlockPlaces& taken) const noexcept {
  std::uint64_t gap = taken.lowest_gap(bytes);
  if (blocks_.size() > most_looked_through) return gap;
  for (const std::size_t k : by_place_) {
    const PlacedBlock& planned = blocks_[k];
    if (k < next || planned.begin >= before || planned.end_place() <= gap) continue;
    if (gap + bytes <= planned.place) return gap;
    gap = taken.lowest_gap(bytes, planned.end_place());
  }
  return gap;
}

}  // namespace abut::device
