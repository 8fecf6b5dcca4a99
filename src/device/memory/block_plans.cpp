#include "device/memory/block_plans.hpp"

#include "device/memory/place_blocks.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace abut::device {
namespace {

constexpr std::size_t most_plans = 4;

/// Where a call goes another way, its next block is looked for among so many of the plan, which
/// may be larger by an eighth.
constexpr std::size_t most_looked_ahead = 32;
constexpr std::uint64_t part_of_alike = 8;

/// Blocks that have grown get a 32nd more, or less where that would be many bytes in all.
constexpr std::uint64_t part_of_growth = 32;
constexpr std::uint64_t most_growth = std::uint64_t{8} << 20;

/// An array for calls that hold so much may be longer by a sixteenth, and by so many bytes, which
/// stand beside the 41 MiB of any detection within the 64 that it may hold whatever its size.
constexpr std::uint64_t part_of_array = 16;
constexpr std::uint64_t most_room = std::uint64_t{16} << 20;

std::uint64_t longest_array_for(std::uint64_t held) {
  return held + std::min(held / part_of_array, most_room);
}

/// Makes blocks as large as both calls need that took them.
void grow_for_both(std::vector<PlacedBlock>& blocks, const std::vector<PlacedBlock>& earlier,
                   std::uint64_t held) {
  const std::uint64_t part = std::max(part_of_growth, held / most_growth);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    std::uint64_t& bytes = blocks[k].bytes;
    bytes = bytes > earlier[k].bytes ? aligned_block(bytes + bytes / part) : earlier[k].bytes;
  }
}

}  // namespace

void BlockPlans::plan_for(const BlockSequence& sequence) {
  const std::uint64_t held = most_held_at_once(sequence.blocks());
  const auto planned = std::find_if(plans_.begin(), plans_.end(), [&](const BlockPlan& plan) {
    return plan.length() <= longest_array_for(held) && plan.has_room_for(sequence.blocks());
  });
  std::vector<BlockPlan> plans;
  if (planned != plans_.end()) {
    plans.push_back(std::move(*planned));
  } else {
    std::vector<PlacedBlock> blocks = sequence.blocks();
    const std::uint64_t length = place_blocks(blocks);
    plans.emplace_back(std::move(blocks), length);
  }
  plans_.swap(plans);
}

void BlockPlans::plan_also_for(const BlockSequence& sequence, std::uint64_t array_bytes) {
  const auto earlier = std::find_if(plans_.begin(), plans_.end(), [&](const BlockPlan& plan) {
    return plan.has_steps_of(sequence.blocks());
  });
  BlockPlan plan = made_for(sequence, earlier == plans_.end() ? nullptr : &*earlier, array_bytes);
  if (earlier != plans_.end()) {
    *earlier = std::move(plan);
    return;
  }
  if (plans_.size() == most_plans) plans_.pop_back();
  plans_.insert(plans_.begin(), std::move(plan));
}

/// First with the places that the call has shared with a plan, so that a call may go over from one
/// to the other; then without them; and in the end for this call alone.
BlockPlan BlockPlans::made_for(const BlockSequence& sequence, const BlockPlan* earlier,
                               std::uint64_t array_bytes) const {
  const std::uint64_t held = most_held_at_once(sequence.blocks());
  const std::uint64_t most = std::max(array_bytes, longest_array_for(held));
  std::vector<PlacedBlock> blocks = sequence.blocks();
  if (earlier != nullptr) grow_for_both(blocks, earlier->blocks(), held);
  for (std::size_t k = 0; k < followed_; ++k) {
    blocks[k].bytes = plans_.front().blocks()[k].bytes;
  }
  for (const std::size_t shared : {followed_, std::size_t{0}}) {
    if (most_held_at_once(blocks) > most) break;
    const std::uint64_t length = place_blocks(blocks, shared, array_bytes);
    if (length <= most) return {std::move(blocks), length};
  }
  blocks = sequence.blocks();
  const std::uint64_t length = place_blocks(blocks, 0, array_bytes);
  return {std::move(blocks), length};
}

std::uint64_t BlockPlans::length() const noexcept {
  std::uint64_t longest = 0;
  for (const BlockPlan& plan : plans_) longest = std::max(longest, plan.length());
  return longest;
}

void BlockPlans::restart() noexcept {
  next_ = 0;
  followed_ = 0;
  is_in_step_ = !plans_.empty();
}

std::uint64_t BlockPlans::place_for_last(const BlockSequence& sequence, const BlockPlaces& taken,
                                         std::uint64_t array_bytes) noexcept {
  const std::vector<PlacedBlock>& blocks = sequence.blocks();
  const std::uint64_t bytes = blocks.back().bytes;
  const PlacedBlock* const planned = find_planned(blocks);
  if (planned != nullptr && planned->bytes >= bytes && taken.is_free(planned->place, bytes)) {
    if (followed_ + 1 == blocks.size()) ++followed_;
    return planned->place;
  }
  const std::uint64_t before =
      planned == nullptr ? std::numeric_limits<std::uint64_t>::max() : planned->end;
  const std::uint64_t gap = plans_.front().gap_beside(next_, before, bytes, taken);
  return gap + bytes <= array_bytes ? gap : taken.lowest_gap(bytes);
}

/// The planned block that the last one is, if there is one. It may be too small.
const PlacedBlock* BlockPlans::find_planned(const std::vector<PlacedBlock>& taken) noexcept {
  if (!is_in_step_) return find_ahead(taken.back().bytes);
  const std::vector<PlacedBlock>& planned = plans_.front().blocks();
  is_in_step_ = next_ < planned.size() && planned[next_].begin == taken.back().begin;
  const bool fits = is_in_step_ && planned[next_].bytes >= taken.back().bytes;
  if (!fits && followed_ + 1 == taken.size() && go_over(taken)) is_in_step_ = true;
  if (!is_in_step_) return find_ahead(taken.back().bytes);
  return &plans_.front().blocks()[next_++];
}

/// Brings another plan to the front that the call has followed as well so far.
bool BlockPlans::go_over(const std::vector<PlacedBlock>& taken) noexcept {
  const auto found = std::find_if(plans_.begin(), plans_.end(),
                                  [&](const BlockPlan& plan) { return plan.begins_as(taken); });
  if (found == plans_.end()) return false;
  std::rotate(plans_.begin(), found, found + 1);
  return true;
}

const PlacedBlock* BlockPlans::find_ahead(std::uint64_t bytes) noexcept {
  const std::vector<PlacedBlock>& planned = plans_.front().blocks();
  const std::size_t end = std::min(next_ + most_looked_ahead, planned.size());
  for (std::size_t k = next_; k < end; ++k) {
    if (planned[k].bytes < bytes || planned[k].bytes - bytes > planned[k].bytes / part_of_alike) {
      continue;
    }
    next_ = k + 1;
    return &planned[k];
  }
  return nullptr;
}

}  // namespace abut::device
