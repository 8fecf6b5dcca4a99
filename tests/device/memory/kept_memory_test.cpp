// Memory that a detector keeps: places in one array, and blocks beside it.

#include "device/memory/kept_memory.hpp"

#include "device/host/host_executor.hpp"
#include "device/memory/block_places.hpp"
#include "device/memory/memory_source.hpp"

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <abut/error.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <new>
#include <stdexcept>
#include <vector>

namespace abut::testing {
namespace {

using device::BlockPlaces;
using device::KeptMemory;
using device::Stream;

/// Takes the lowest gap.
std::uint64_t taken(BlockPlaces& places, std::uint64_t bytes) {
  const std::uint64_t place = places.lowest_gap(bytes);
  places.take(place, bytes);
  return place;
}

TEST(DeviceBlockPlaces, AreTheLowestGapsThatFit) {
  BlockPlaces places;
  EXPECT_EQ(taken(places, 10), 0U);
  EXPECT_EQ(taken(places, 20), 10U);
  EXPECT_EQ(taken(places, 30), 30U);
  places.give_back(10);
  EXPECT_EQ(taken(places, 21), 60U);
  EXPECT_EQ(taken(places, 15), 10U);
  EXPECT_EQ(taken(places, 5), 25U);
  places.give_back(0);
  EXPECT_EQ(taken(places, 10), 0U);
  EXPECT_EQ(places.lowest_gap(1000), 81U);
  EXPECT_EQ(places.length(), 81U);
}

TEST(DeviceBlockPlaces, NeverOverlap) {
  scenes::Random random(4);
  BlockPlaces places;
  std::map<std::uint64_t, std::uint64_t> ends;
  for (int step = 0; step < 5000; ++step) {
    if (ends.size() > 20 || (!ends.empty() && random.uniform(0.0, 1.0) < 0.4)) {
      auto which = ends.begin();
      std::advance(which, static_cast<std::ptrdiff_t>(random.uniform(0.0, 1.0) *
                                                      static_cast<double>(ends.size())));
      places.give_back(which->first);
      ends.erase(which);
      continue;
    }
    const auto bytes = 1 + static_cast<std::uint64_t>(random.uniform(0.0, 1000.0));
    const std::uint64_t place = taken(places, bytes);
    const auto behind = ends.lower_bound(place);
    EXPECT_TRUE(behind == ends.end() || place + bytes <= behind->first);
    EXPECT_TRUE(behind == ends.begin() || std::prev(behind)->second <= place);
    ends[place] = place + bytes;
    EXPECT_LE(place + bytes, places.length());
  }
  EXPECT_LE(places.length(), 21U * 1000U * 2U);
}

constexpr std::uint64_t no_bound = base::MemoryMeter::unbounded;

/// A call that holds 1000 bytes, then 300 and 500 at once.
void call(KeptMemory& memory) {
  void* const first = memory.take(1000);
  memory.give_back(first, 1000);
  void* const second = memory.take(300);
  void* const third = memory.take(500);
  memory.give_back(second, 300);
  memory.give_back(third, 500);
}

TEST(DeviceKeptMemory, IsOneBlockFromTheSecondCallOn) {
  MemorySource source;
  {
    KeptMemory memory(source.functions());
    memory.begin(no_bound, {});
    call(memory);
    EXPECT_EQ(source.requests, 3U);
    EXPECT_EQ(memory.peak(), 1000U);
    EXPECT_EQ(memory.held(), 0U);
    for (int again = 0; again < 3; ++again) {
      memory.begin(no_bound, {});
      call(memory);
      EXPECT_EQ(source.requests, 4U);
      EXPECT_EQ(memory.peak(), 1024U);
      EXPECT_EQ(memory.held(), 1024U);
    }
    // More than it has is taken beside it, and in one piece the next time.
    memory.begin(no_bound, {});
    void* const more = memory.take(5000);
    EXPECT_EQ(source.requests, 5U);
    memory.give_back(more, 5000);
    memory.begin(no_bound, {});
    EXPECT_EQ(source.requests, 6U);
    EXPECT_EQ(memory.held(), 5120U);
    EXPECT_EQ(source.blocks, 1);
  }
  EXPECT_EQ(source.blocks, 0);
}

TEST(DeviceKeptMemory, IsTakenAnewInAnotherStream) {
  int handle = 0;
  MemorySource source;
  KeptMemory memory(source.functions());
  memory.begin(no_bound, {});
  call(memory);
  memory.begin(no_bound, {});
  call(memory);
  source.streams.clear();
  memory.begin(no_bound, {&handle});
  EXPECT_EQ(source.streams, (std::vector<void*>{nullptr, &handle}));
}

TEST(DeviceKeptMemory, IsGivenUpForABoundOrForWantOfIt) {
  MemorySource source;
  KeptMemory memory(source.functions());
  memory.begin(no_bound, {});
  call(memory);
  memory.begin(no_bound, {});
  EXPECT_EQ(memory.held(), 1024U);
  memory.begin(1000, {});
  EXPECT_EQ(memory.held(), 0U);
  call(memory);
  expect_error(ErrorCode::limit_exceeded, {"bytes are needed"},
               [&] { static_cast<void>(memory.take(1001)); });
  EXPECT_EQ(memory.held(), 0U);
  source.largest = 1000;
  memory.begin(no_bound, {});
  call(memory);
  EXPECT_EQ(memory.take(1001), nullptr);
  EXPECT_EQ(memory.held(), 0U);
  EXPECT_EQ(source.blocks, 0);
}

/// Calls that hold 1024 bytes, and some more beside them, within a bound.
class GrowingCalls {
 public:
  explicit GrowingCalls(MemorySource& source) : memory_(source.functions()) {}

  /// Returns the peak of a call.
  std::uint64_t run(std::uint64_t more) {
    tries = 0;
    return memory_.run(3072, {}, [&] {
      ++tries;
      Block first(memory_, 1024);
      Block second(memory_, more);
      return memory_.peak();
    });
  }

  int tries = 0;  ///< of the last call

 private:
  struct Block {
    Block(KeptMemory& memory, std::uint64_t size)
        : of(memory), bytes(size), address(memory.take(size)) {
      if (address == nullptr) throw std::bad_alloc();
    }
    ~Block() { of.give_back(address, bytes); }

    KeptMemory& of;
    std::uint64_t bytes;
    void* address;
  };

  KeptMemory memory_;
};

/// A call that needs a little more than the one before: the whole block would lie beside the array,
/// whose end would be of no use.
TEST(DeviceKeptMemory, IsTakenAnewWhereItsArrayIsInTheWay) {
  MemorySource source;
  GrowingCalls calls(source);
  EXPECT_EQ(calls.run(1024), 2048U);
  EXPECT_EQ(calls.run(1024), 2048U);
  EXPECT_EQ(calls.tries, 1);
  // Beside the array of 2048 bytes it would pass the bound.
  EXPECT_EQ(calls.run(1280), 2304U);
  EXPECT_EQ(calls.tries, 2);
  EXPECT_EQ(calls.run(1280), 2304U);
  EXPECT_EQ(calls.tries, 1);
  // The same where the allocator has no more.
  source.most_at_once = 3000;
  EXPECT_EQ(calls.run(1536), 2560U);
  EXPECT_EQ(calls.tries, 2);
  // What no call can have is tried once more, and is not asked for by the next one.
  expect_error(ErrorCode::limit_exceeded, {"bytes are needed"}, [&] { calls.run(4096); });
  EXPECT_EQ(calls.tries, 2);
  source.requests = 0;
  EXPECT_EQ(calls.run(1024), 2048U);
  EXPECT_EQ(calls.tries, 1);
  EXPECT_EQ(source.requests, 2U);
}

/// Other errors than a lack of memory end a call at once.
TEST(DeviceKeptMemory, RunsNothingTwiceForAnotherError) {
  MemorySource source;
  KeptMemory memory(source.functions());
  for (int call_before = 0; call_before < 2; ++call_before) {
    memory.run(no_bound, {}, [&] { call(memory); });
  }
  int tries = 0;
  const auto refuse = [&] {
    ++tries;
    call(memory);
    throw Error(ErrorCode::limit_exceeded, "pairs");
  };
  EXPECT_THROW(memory.run(no_bound, {}, refuse), Error);
  EXPECT_EQ(tries, 1);
}

TEST(DeviceKeptMemory, RefusesBlocksThatAreNotAligned) {
  MemorySource source;
  device::Allocator functions = source.functions();
  functions.allocate = [give = functions.allocate](std::uint64_t bytes, Stream stream) -> void* {
    return static_cast<std::byte*>(give(bytes + 64, stream)) + 64;
  };
  functions.release = [take = functions.release](void* block, std::uint64_t bytes, Stream stream) {
    take(static_cast<std::byte*>(block) - 64, bytes + 64, stream);
  };
  KeptMemory memory(functions);
  memory.begin(no_bound, {});
  expect_error(ErrorCode::wrong_usage, {"1000 bytes", "multiple of 256"},
               [&] { static_cast<void>(memory.take(1000)); });
  EXPECT_EQ(memory.held(), 0U);
  EXPECT_EQ(source.blocks, 0);
}

/// What was not given counts nothing: the bound is as far away as before.
TEST(DeviceKeptMemory, AnAllocatorMayThrow) {
  bool throws = true;
  MemorySource source;
  device::Allocator functions = source.functions();
  functions.allocate = [&, give = functions.allocate](std::uint64_t bytes, Stream stream) {
    if (throws) throw std::out_of_range("mine");
    return give(bytes, stream);
  };
  KeptMemory memory(functions);
  memory.begin(1000, {});
  for (int again = 0; again < 3; ++again) {
    EXPECT_THROW(static_cast<void>(memory.take(600)), std::out_of_range);
  }
  throws = false;
  call(memory);
  EXPECT_EQ(source.blocks, 0);
}

TEST(DeviceHostExecutor, GivesBackWhatItCouldNotHave) {
  base::MemoryMeter memory;
  device::HostExecutor executor(memory, device::ItemOrder::ascending, 1);
  EXPECT_THROW(static_cast<void>(executor.allocate(std::uint64_t{1} << 60)), std::bad_alloc);
  EXPECT_EQ(memory.held(), 0U);
}

}  // namespace
}  // namespace abut::testing
