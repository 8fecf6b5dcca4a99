// Memory that a detector keeps: places in one array, and blocks beside it.

#include "device/kept_memory.hpp"

#include "device/block_places.hpp"
#include "device/host/host_executor.hpp"

#include "scenes/random.hpp"
#include "support/error_expectations.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
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

TEST(DeviceBlockPlaces, AreTheLowestGapsThatFit) {
  BlockPlaces places;
  EXPECT_EQ(places.take(10), 0U);
  EXPECT_EQ(places.take(20), 10U);
  EXPECT_EQ(places.take(30), 30U);
  places.give_back(10);
  EXPECT_EQ(places.take(21), 60U);
  EXPECT_EQ(places.take(15), 10U);
  EXPECT_EQ(places.take(5), 25U);
  places.give_back(0);
  EXPECT_EQ(places.take(10), 0U);
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
    const std::uint64_t place = places.take(bytes);
    const auto behind = ends.lower_bound(place);
    EXPECT_TRUE(behind == ends.end() || place + bytes <= behind->first);
    EXPECT_TRUE(behind == ends.begin() || std::prev(behind)->second <= place);
    ends[place] = place + bytes;
    EXPECT_LE(place + bytes, places.length());
  }
  EXPECT_LE(places.length(), 21U * 1000U * 2U);
}

/// An allocator of the host that counts, and refuses what is larger than it is told.
struct Source {
  std::uint64_t requests = 0;
  std::uint64_t largest = ~std::uint64_t{0};
  std::vector<void*> streams;
  std::int64_t blocks = 0;

  device::Allocator functions() {
    return {[this](std::uint64_t bytes, Stream stream) -> void* {
              ++requests;
              streams.push_back(stream.handle);
              if (bytes > largest) return nullptr;
              ++blocks;
              return std::malloc(bytes);
            },
            [this](void* block, std::uint64_t, Stream stream) {
              streams.push_back(stream.handle);
              --blocks;
              std::free(block);
            }};
  }
};

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
  Source source;
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
  Source source;
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
  Source source;
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

/// What was not given counts nothing: the bound is as far away as before.
TEST(DeviceKeptMemory, AnAllocatorMayThrow) {
  bool throws = true;
  Source source;
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
