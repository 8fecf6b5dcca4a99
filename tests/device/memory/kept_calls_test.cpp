// Calls one after the other in the memory that a detector keeps: alike, smaller, larger, and others
// than before. Blocks never overlap, and nothing is allocated where nothing grows.

#include "device/memory/block_script.hpp"
#include "device/memory/kept_memory.hpp"
#include "device/memory/memory_source.hpp"
#include "scenes/random.hpp"
#include "support/allocation_faults.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace abut::testing {
namespace {

using device::KeptMemory;

constexpr std::uint64_t seed = 73;

/// Scripts of as many blocks as a detection has.
std::vector<BlockScript> made_scripts(scenes::Random& random, std::size_t count) {
  std::vector<BlockScript> scripts;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t blocks = 20 + random.below(130);
    scripts.emplace_back(random, blocks, 3 + random.below(20));
  }
  return scripts;
}

/// The same call again, and those that need less of any block.
TEST(DeviceKeptCalls, AllocateNothingWhereNothingGrows) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed);
  for (const BlockScript& script : made_scripts(random, 60)) {
    MemorySource source;
    {
      KeptMemory memory(source.functions());
      EXPECT_LE(run_call(memory, script), script.most_held());
      const std::uint64_t array = run_call(memory, script);
      EXPECT_GE(array, script.most_held());
      EXPECT_LE(array, script.most_held() * 115 / 100);
      source.requests = 0;
      for (const double least : {1.0, 0.99, 0.9, 0.3, 0.0}) {
        EXPECT_EQ(run_call(memory, script.scaled(random, least, 1.0)), array);
        EXPECT_EQ(run_call(memory, script), array);
      }
      EXPECT_EQ(source.requests, 0U);
      EXPECT_EQ(source.blocks, 1);
    }
    EXPECT_EQ(source.blocks, 0);
  }
}

/// Whatever comes after whatever else, blocks are apart, and the array is no longer than one of the
/// calls needs, but for the room to grow.
TEST(DeviceKeptCalls, StayRightWhereTheyDiverge) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 2);
  for (int round = 0; round < 20; ++round) {
    const std::vector<BlockScript> scripts = made_scripts(random, 4);
    MemorySource source;
    KeptMemory memory(source.functions());
    std::uint64_t most = 0;
    for (int call = 0; call < 60; ++call) {
      BlockScript script = scripts[random.below(4)];
      if (random.uniform() < 0.5) script = script.scaled(random, 0.9, 1.05);
      if (random.uniform() < 0.5) script = script.without_some(random, 0.1);
      most = std::max(most, script.most_held());
      run_call(memory, script);
      EXPECT_LE(memory.held(), most * 125 / 100);
      EXPECT_LE(source.blocks, 1);
    }
  }
}

/// Sizes go up and down by some per cent from call to call, each for itself, as in a simulation.
TEST(DeviceKeptCalls, SettleWhereSizesGoUpAndDown) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 3);
  std::uint64_t requests = 0;
  for (const BlockScript& script : made_scripts(random, 40)) {
    MemorySource source;
    KeptMemory memory(source.functions());
    for (int call = 0; call < 20; ++call) run_call(memory, script.scaled(random, 0.96, 1.0));
    source.requests = 0;
    for (int call = 0; call < 50; ++call) run_call(memory, script.scaled(random, 0.96, 1.0));
    requests += source.requests;
  }
  EXPECT_LE(requests, 40U) << "in 2000 calls";
}

/// Where all grows slowly, the array is taken anew once in many calls.
TEST(DeviceKeptCalls, HaveRoomToGrow) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 4);
  for (const BlockScript& script : made_scripts(random, 6)) {
    MemorySource source;
    KeptMemory memory(source.functions());
    double size = 1.0;
    int calls_that_grew = 0;
    for (int call = 0; call < 200; ++call, size *= 1.001) {
      source.requests = 0;
      const BlockScript larger = script.scaled(random, size, size);
      run_call(memory, larger);
      if (source.requests > 0) ++calls_that_grew;
      EXPECT_LE(memory.held(), larger.most_held() * 125 / 100);
    }
    EXPECT_LE(calls_that_grew, 60);
  }
}

/// Calls with no step in common, and such as are alike at first, take turns.
TEST(DeviceKeptCalls, MayTakeTurns) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 5);
  std::uint64_t requests = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<BlockScript> scripts = made_scripts(random, 2);
    if (round % 2 == 0) scripts[1] = scripts[0].without_some(random, 0.05);
    MemorySource source;
    KeptMemory memory(source.functions());
    for (std::size_t call = 0; call < 10; ++call) run_call(memory, scripts[call % 2]);
    source.requests = 0;
    for (std::size_t call = 0; call < 10; ++call) run_call(memory, scripts[call % 2]);
    requests += source.requests;
  }
  EXPECT_LE(requests, 40U) << "in 400 calls";
}

/// What others took in between does not lengthen the array.
TEST(DeviceKeptCalls, ForgetWhatIsTooLong) {
  scenes::Random random(seed + 6);
  const BlockScript script(random, 100, 10);
  MemorySource source;
  KeptMemory memory(source.functions());
  for (int call = 0; call < 2; ++call) run_call(memory, script);
  const std::uint64_t array = memory.held();
  run_call(memory, script.scaled(random, 3.0, 3.0));
  // Without its array a call plans for itself alone.
  EXPECT_LE(run_call(memory, script, array), array);
  EXPECT_EQ(run_call(memory, script, array), array);
  EXPECT_EQ(source.blocks, 1);
}

/// A call that ended early, and not for want of memory, leaves the array and its plan.
TEST(DeviceKeptCalls, MayEndEarly) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 7);
  for (const BlockScript& script : made_scripts(random, 20)) {
    MemorySource source;
    KeptMemory memory(source.functions());
    for (int call = 0; call < 2; ++call) run_call(memory, script);
    const BlockScript other(random, 50, 20);
    EXPECT_THROW(memory.run(base::MemoryMeter::unbounded, {},
                            [&] {
                              RunningBlocks(memory).run(other);
                              throw Error(ErrorCode::cancelled, "by a hook");
                            }),
                 Error);
    source.requests = 0;
    run_call(memory, script);
    EXPECT_EQ(source.requests, 0U);
  }
}

/// Where the allocator has no more than what a first call holds, no later call ends for want of it,
/// whatever came before.
TEST(DeviceKeptCalls, EndAsTheFirstWould) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 8);
  for (int round = 0; round < 20; ++round) {
    const std::vector<BlockScript> scripts = made_scripts(random, 4);
    MemorySource source;
    KeptMemory memory(source.functions());
    for (int call = 0; call < 30; ++call) {
      const BlockScript script = scripts[random.below(4)].scaled(random, 0.5, 1.1);
      source.most_at_once = ~std::uint64_t{0};
      if (random.uniform() < 0.3) {
        run_call(memory, script);
        continue;
      }
      const std::uint64_t most = script.most_held();
      EXPECT_LE(run_call(memory, script, most), most);
      memory.begin(0, {});  // gives the array back
      source.most_at_once = most;
      EXPECT_NO_THROW(run_call(memory, script));
      EXPECT_LE(source.blocks, 1);
    }
  }
}

/// A block that could not be had leaves nothing behind: neither in the array of the next call nor
/// in that of this one.
TEST(DeviceKeptCalls, GoOnWhereABlockCouldNotBeHad) {
  MemorySource source;
  source.streams.reserve(100);
  KeptMemory memory(source.functions());
  const auto take_one = [&] {
    for (std::uint64_t which = 0; which < 10; ++which) {
      const AllocationFault fault(which % 5);
      try {
        void* const block = memory.take(1000);
        if (block != nullptr) memory.give_back(block, 1000);
      } catch (const std::bad_alloc&) {
        continue;
      }
    }
  };
  memory.begin(base::MemoryMeter::unbounded, {});
  take_one();
  source.largest = 1000;
  EXPECT_EQ(memory.take(5000), nullptr);
  memory.begin(base::MemoryMeter::unbounded, {});
  source.largest = 1024;
  memory.begin(base::MemoryMeter::unbounded, {});
  EXPECT_EQ(memory.held(), 1024U);
  take_one();
  source.requests = 0;
  memory.give_back(memory.take(1000), 1000);
  EXPECT_EQ(source.requests, 0U);
}

/// Memory of the host is refused once, at each place where the second or third call asks for it:
/// nothing is lost, and calls go on.
TEST(DeviceKeptCalls, LoseNothingForWantOfMemoryOfTheHost) {
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  scenes::Random random(seed + 9);
  const BlockScript script(random, 12, 5);
  const BlockScript larger = script.scaled(random, 1.0, 2.0);
  std::uint64_t refused = 0;
  for (std::uint64_t which = 0;; ++which) {
    MemorySource source;
    source.streams.reserve(1000);
    {
      KeptMemory memory(source.functions());
      run_call(memory, script);
      AllocationFault fault(which);
      for (const BlockScript* const next : {&script, &larger, &larger}) {
        try {
          run_call(memory, *next);
        } catch (const std::bad_alloc&) {
          ++refused;
        }
      }
      fault.disarm();
      EXPECT_LE(source.blocks, 1);
      if (fault.requests() <= which) break;
      for (int call = 0; call < 2; ++call) run_call(memory, larger);
      source.requests = 0;
      run_call(memory, larger);
      EXPECT_EQ(source.requests, 0U);
    }
    EXPECT_EQ(source.blocks, 0);
  }
  EXPECT_GT(refused, 30U);
}

}  // namespace
}  // namespace abut::testing
