// Blocks of a call placed in one array: those that are there at the same time never overlap, and
// the array is hardly longer than what they hold.

#include "device/memory/place_blocks.hpp"

#include "device/memory/block_places.hpp"
#include "device/memory/block_plans.hpp"
#include "device/memory/block_script.hpp"
#include "device/memory/block_sequence.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using device::BlockSequence;
using device::PlacedBlock;

constexpr std::uint64_t seed = 37;

BlockSequence sequence_of(const BlockScript& script) {
  BlockSequence sequence;
  for (const BlockScript::Step& step : script.steps()) {
    if (step.bytes == 0) {
      sequence.give_back(step.block);
    } else {
      static_cast<void>(sequence.take(step.bytes));
    }
  }
  return sequence;
}

void expect_no_overlap(const std::vector<PlacedBlock>& blocks, std::uint64_t length) {
  for (std::size_t a = 0; a < blocks.size(); ++a) {
    EXPECT_LE(blocks[a].end_place(), length);
    for (std::size_t b = 0; b < a; ++b) {
      if (!blocks[a].is_beside_in_time(blocks[b])) continue;
      EXPECT_TRUE(blocks[a].end_place() <= blocks[b].place ||
                  blocks[b].end_place() <= blocks[a].place)
          << a << " and " << b;
    }
  }
}

/// The length that it would have if each took the lowest gap as it comes.
std::uint64_t length_of_lowest_gaps(const BlockScript& script) {
  device::BlockPlaces places;
  std::vector<std::uint64_t> at;
  for (const BlockScript::Step& step : script.steps()) {
    if (step.bytes == 0) {
      places.give_back(at[step.block]);
      continue;
    }
    const std::uint64_t bytes = device::aligned_block(step.bytes);
    at.push_back(places.lowest_gap(bytes));
    places.take(at.back(), bytes);
  }
  return places.length();
}

TEST(DevicePlaceBlocks, KeepsApartWhatIsThereAtTheSameTime) {
  scenes::Random random(seed);
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  double longest = 0.0;
  double all = 0.0;
  for (int which = 0; which < 300; ++which) {
    const std::size_t blocks_in_script = 1 + random.below(150);
    const BlockScript script(random, blocks_in_script, 1 + random.below(30));
    std::vector<PlacedBlock> blocks = sequence_of(script).blocks();
    const std::uint64_t length = device::place_blocks(blocks);
    expect_no_overlap(blocks, length);
    EXPECT_EQ(device::most_held_at_once(blocks), script.most_held());
    EXPECT_GE(length, script.most_held());
    EXPECT_LE(length, length_of_lowest_gaps(script));
    const double ratio = static_cast<double>(length) / static_cast<double>(script.most_held());
    longest = std::max(longest, ratio);
    all += ratio / 300;
  }
  EXPECT_LE(longest, 1.15);
  EXPECT_LE(all, 1.01);
  RecordProperty("longest", std::to_string(longest));
  RecordProperty("mean", std::to_string(all));
}

/// A block that comes late and is large would lie behind all others if each took the lowest gap.
TEST(DevicePlaceBlocks, LeavesNoGapBelowALargeBlock) {
  BlockSequence sequence;
  const std::size_t first = sequence.take(1000 * 256);
  const std::size_t small = sequence.take(256);
  sequence.give_back(first);
  const std::size_t large = sequence.take(1999 * 256);
  sequence.give_back(small);
  sequence.give_back(large);
  std::vector<PlacedBlock> blocks = sequence.blocks();
  EXPECT_EQ(device::place_blocks(blocks), 2000U * 256);
  EXPECT_EQ(blocks[large].place, 0U);
  expect_no_overlap(blocks, 2000U * 256);
}

/// Of calls that hold much, and of those that hold little.
TEST(DevicePlaceBlocks, RoomToGrowHasABound) {
  constexpr std::uint64_t mib = std::uint64_t{1} << 20;
  for (const std::uint64_t bytes : {mib, 100 * mib, 100'000 * mib}) {
    SCOPED_TRACE(bytes);
    device::BlockPlans plans;
    const auto sequence_of_two = [&](std::uint64_t second) {
      BlockSequence sequence;
      static_cast<void>(sequence.take(bytes));
      static_cast<void>(sequence.take(second));
      return sequence;
    };
    plans.plan_for(sequence_of_two(bytes));
    EXPECT_EQ(plans.length(), 2 * bytes);
    const std::uint64_t held = 2 * bytes + bytes / 64;
    plans.plan_also_for(sequence_of_two(held - bytes), plans.length());
    EXPECT_GT(plans.length(), held);
    EXPECT_LE(plans.length(), held + std::min(held / 16, 16 * mib));
  }
}

/// More than are compared with each other are placed as they come.
TEST(DevicePlaceBlocks, TakesAnyNumber) {
  scenes::Random random(seed + 1);
  const BlockScript script(random, 3000, 20);
  std::vector<PlacedBlock> blocks = sequence_of(script).blocks();
  const std::uint64_t length = device::place_blocks(blocks);
  expect_no_overlap(blocks, length);
  EXPECT_EQ(length, length_of_lowest_gaps(script));
  std::vector<PlacedBlock> none;
  EXPECT_EQ(device::place_blocks(none), 0U);
}

/// Blocks that are not given back are there to the end.
TEST(DevicePlaceBlocks, KeepsApartWhatStays) {
  BlockSequence sequence;
  static_cast<void>(sequence.take(500));
  sequence.give_back(sequence.take(700));
  static_cast<void>(sequence.take(600));
  std::vector<PlacedBlock> blocks = sequence.blocks();
  EXPECT_EQ(device::place_blocks(blocks), 512U + 768U);
  expect_no_overlap(blocks, 512U + 768U);
}

/// The same of many, in whatever order they are placed.
TEST(DevicePlaceBlocks, KeepsApartManyThatStay) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed + 2);
  scenes::Random random(seed + 2);
  for (int which = 0; which < 100; ++which) {
    const BlockScript script(random, 20 + random.below(100), 10);
    std::vector<PlacedBlock> blocks = sequence_of(script).blocks();
    for (PlacedBlock& block : blocks) {
      if (random.below(8) == 0) block.end = PlacedBlock{}.end;
    }
    expect_no_overlap(blocks, device::place_blocks(blocks));
  }
}

}  // namespace
}  // namespace abut::testing
