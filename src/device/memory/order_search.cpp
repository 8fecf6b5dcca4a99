#include "device/memory/order_search.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace abut::device {
namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

/// Blocks are the fullest that are there when 15 sixteenths of the most are held, and that are no
/// smaller than a 256th of it.
constexpr std::uint64_t part_of_free = 16;
constexpr std::uint64_t part_of_large = 256;

/// How many blocks are placed anew in all changes together: nearly all calls do with a tenth of it,
/// and a millisecond.
constexpr std::size_t most_turns = 300'000;

/// Bytes held after each step of a call.
std::vector<std::uint64_t> held_after_steps(const std::vector<PlacedBlock>& blocks) {
  std::vector<std::uint64_t> held(2 * blocks.size());
  for (const PlacedBlock& block : blocks) {
    held[block.begin] += block.bytes;
    if (block.end < held.size()) held[block.end] -= block.bytes;
  }
  std::partial_sum(held.begin(), held.end(), held.begin());
  return held;
}

/// Most bytes held while a block is there.
std::uint64_t most_held_beside(const PlacedBlock& block, const std::vector<std::uint64_t>& held) {
  const std::uint64_t end = std::min<std::uint64_t>(block.end, held.size());
  return *std::max_element(held.begin() + static_cast<std::ptrdiff_t>(block.begin),
                           held.begin() + static_cast<std::ptrdiff_t>(end));
}

}  // namespace

OrderSearch::OrderSearch(std::vector<PlacedBlock>& blocks, std::size_t placed, std::uint64_t length,
                         std::uint64_t most_held)
    : best_(blocks),
      blocks_(blocks),
      placed_(placed),
      finder_(blocks_, placed),
      length_(length),
      most_held_(most_held),
      order_(blocks.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
}

std::uint64_t OrderSearch::run(std::uint64_t short_enough) {
  short_enough_ = short_enough;
  place_by([](const PlacedBlock& block) {
    return std::pair(std::bit_width(block.bytes), block.end - block.begin);
  });
  place_by([](const PlacedBlock& block) { return block.bytes; });
  put_fullest_first();
  change_turns();
  return length_;
}

bool OrderSearch::place_all() {
  const std::uint64_t length = finder_.place(order_, length_);
  if (length >= length_) return false;
  length_ = length;
  best_ = blocks_;
  return true;
}

/// Of two blocks of equal weight the order stays. std::stable_sort would be exported from the
/// library.
void OrderSearch::put_heaviest_first(const auto& weight_of) {
  std::vector<decltype(weight_of(blocks_.front()))> weights;
  for (const PlacedBlock& block : blocks_) weights.push_back(weight_of(block));
  std::vector<std::size_t> turns(order_.size());
  for (std::size_t turn = 0; turn < order_.size(); ++turn) turns[order_[turn]] = turn;
  std::sort(order_.begin() + static_cast<std::ptrdiff_t>(placed_), order_.end(),
            [&](std::size_t a, std::size_t b) {
              return weights[a] != weights[b] ? weights[a] > weights[b] : turns[a] < turns[b];
            });
}

void OrderSearch::place_by(const auto& weight_of) {
  if (is_done()) return;
  put_heaviest_first(weight_of);
  place_all();
}

void OrderSearch::put_fullest_first() {
  if (is_done()) return;
  const std::vector<std::uint64_t> held = held_after_steps(blocks_);
  const std::uint64_t full = most_held_ - most_held_ / part_of_free;
  const auto is_fullest = [&](const PlacedBlock& block) {
    return block.bytes >= most_held_ / part_of_large && most_held_beside(block, held) >= full;
  };
  put_heaviest_first(is_fullest);
  fullest_ = static_cast<std::size_t>(
      std::count_if(order_.begin() + static_cast<std::ptrdiff_t>(placed_), order_.end(),
                    [&](std::size_t k) { return is_fullest(blocks_[k]); }));
  place_all();
}

/// Changes that make the array of the fullest blocks no longer stay; where it could be the shortest
/// for all, the others are placed beside these.
void OrderSearch::change_turns() {
  std::uint64_t least = length_of_fullest(no_limit);
  for (std::size_t taken = 0; taken < most_turns && fullest_ > 1 && !is_done(); taken += fullest_) {
    const TwoTurns some[]{any_two(), any_two()};
    const auto changes = std::span(some).first(1 + random_() % 2);
    for (const TwoTurns& turns : changes) change(turns);
    const std::uint64_t length = length_of_fullest(least + 1);
    if (length > least) {
      std::for_each(changes.rbegin(), changes.rend(),
                    [this](const TwoTurns& turns) { change(turns); });
      continue;
    }
    least = length;
    if (least >= length_ || place_all()) continue;
    take_among_fullest(finder_.placed_count());
    least = length_of_fullest(no_limit);
  }
}

/// The block with this turn is the last of them then.
void OrderSearch::take_among_fullest(std::size_t turn) {
  const auto taken = order_.begin() + static_cast<std::ptrdiff_t>(turn);
  std::rotate(order_.begin() + static_cast<std::ptrdiff_t>(placed_ + fullest_), taken, taken + 1);
  ++fullest_;
}

std::uint64_t OrderSearch::length_of_fullest(std::uint64_t limit) {
  return finder_.place(std::span(order_).first(placed_ + fullest_), limit);
}

}  // namespace abut::device
