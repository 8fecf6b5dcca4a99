#include "base/array.hpp"

#include <gtest/gtest.h>
#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

TEST(Array, HoldsItsBytesWhileItLives) {
  base::MemoryMeter meter;
  {
    const auto numbers = base::make_array<std::int32_t>(meter, 1000, -1);
    EXPECT_EQ(numbers.size(), 1000u);
    EXPECT_EQ(std::count(numbers.begin(), numbers.end(), -1), 1000);
    EXPECT_EQ(meter.held(), 4000u);
    const auto overwritten = base::make_array_for_overwrite<double>(meter, 10);
    EXPECT_EQ(overwritten.size(), 10u);
    EXPECT_EQ(meter.held(), 4080u);
  }
  EXPECT_EQ(meter.held(), 0u);
  EXPECT_EQ(meter.peak(), 4080u);
}

TEST(Array, CopiesAndMovesAreCountedRightly) {
  base::MemoryMeter meter;
  auto numbers = base::make_array<std::int32_t>(meter, 100, 7);
  {
    const auto copy = numbers;
    EXPECT_EQ(meter.held(), 800u);
    EXPECT_EQ(copy, numbers);
  }
  const auto moved = std::move(numbers);
  EXPECT_EQ(meter.held(), 400u);
  EXPECT_EQ(moved[99], 7);
}

TEST(Array, GrowsWithinTheBound) {
  base::MemoryMeter meter(10000);
  auto numbers = base::make_array_for_overwrite<std::int32_t>(meter, 0);
  EXPECT_THROW(while (true) numbers.push_back(static_cast<std::int32_t>(numbers.size())), Error);
  EXPECT_LE(meter.peak(), 10000u);
  EXPECT_GE(numbers.size(), 1000u);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    ASSERT_EQ(numbers[k], static_cast<std::int32_t>(k)) << "nothing is lost by the refusal";
  }
  EXPECT_EQ(meter.held(), numbers.capacity() * 4);
}

TEST(Array, GrowsByAnEighthMoreThanIsAskedForUnlessItIsNew) {
  std::vector<int> numbers;
  base::reserve_to_grow(numbers, 1000);
  EXPECT_EQ(numbers.capacity(), 1000u);
  base::reserve_to_grow(numbers, 1000);
  EXPECT_EQ(numbers.capacity(), 1000u);
  base::reserve_to_grow(numbers, 1016);
  EXPECT_EQ(numbers.capacity(), 1143u);
  base::reserve_to_grow(numbers, 7);
  EXPECT_EQ(numbers.capacity(), 1143u);
}

TEST(Array, WhatPassesTheBoundIsRefusedBeforeItIsAllocated) {
  // No machine has 2^60 bytes: had the allocation been tried, it would be std::bad_alloc.
  base::MemoryMeter meter(1 << 20);
  EXPECT_THROW(static_cast<void>(base::make_array<std::int32_t>(meter, std::size_t{1} << 58, 0)),
               Error);
  EXPECT_THROW(
      static_cast<void>(base::make_array_for_overwrite<double>(meter, std::size_t{1} << 57)),
      Error);
  EXPECT_EQ(meter.held(), 0u);
  EXPECT_EQ(meter.peak(), 0u);
}

TEST(Array, AFailedAllocationIsGivenBack) {
  base::MemoryMeter meter;
  EXPECT_THROW(
      static_cast<void>(base::make_array_for_overwrite<double>(meter, std::size_t{1} << 57)),
      std::bad_alloc);
  EXPECT_EQ(meter.held(), 0u);
}

TEST(Array, LargeBlocksAreUsableFromEndToEnd) {
  base::MemoryMeter meter;
  auto numbers =
      base::make_array_for_overwrite<std::int64_t>(meter, (std::size_t{5} << 20) / 8 + 1);
  std::fill(numbers.begin(), numbers.end(), 3);
  EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 3),
            static_cast<std::ptrdiff_t>(numbers.size()));
}

}  // namespace
}  // namespace abut::testing
