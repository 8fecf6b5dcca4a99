#include "reference/partition_sort.hpp"

#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

testing::NobodyAsked nobody;
base::WorkCounter& work = nobody.work;

using Numbers = std::vector<std::int32_t>;

Numbers sorted(Numbers values) {
  reference::CompanionArrays<1>({std::span(values)}).sort(0, values.size(), work);
  return values;
}

Numbers sorted_by_the_library(Numbers values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// Neighbours among the small numbers, which a truncated mean cannot split.
Numbers random_numbers(scenes::Random& random, std::size_t size) {
  const std::int32_t largest = std::array{1, 2, 3, 100, 2147483647}[random.below(5)];
  std::uniform_int_distribution<std::int32_t> number(0, largest);
  Numbers values(size);
  for (std::int32_t& value : values) value = number(random);
  return values;
}

TEST(PartitionSort, TwoNeighboringValuesAreSplit) {
  EXPECT_EQ(sorted({2, 1}), (Numbers{1, 2}));
  EXPECT_EQ(sorted({1, 2}), (Numbers{1, 2}));
  EXPECT_EQ(sorted({2, 1, 2, 1, 1}), (Numbers{1, 1, 1, 2, 2}));
  EXPECT_EQ(sorted({1, 0}), (Numbers{0, 1}));
}

TEST(PartitionSort, TheMiddleLeavesSomethingOnBothSides) {
  EXPECT_EQ(reference::partition_middle(1, 16), 8);
  for (std::int32_t lowest = 0; lowest < 20; ++lowest) {
    for (std::int32_t highest = lowest + 1; highest < 40; ++highest) {
      EXPECT_GT(reference::partition_middle(lowest, highest), lowest);
      EXPECT_LE(reference::partition_middle(lowest, highest), highest);
    }
  }
  EXPECT_LE(reference::partition_middle(0, 2147483647), 2147483647);
}

TEST(PartitionSort, NothingOneAllEqual) {
  EXPECT_EQ(sorted({}), Numbers{});
  EXPECT_EQ(sorted({7}), Numbers{7});
  EXPECT_EQ(sorted(Numbers(1000, 7)), Numbers(1000, 7));
}

TEST(PartitionSort, NegativeNumbersAndTheWholeRange) {
  constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(sorted({most, -1, least, 0, most, least}), (Numbers{least, least, -1, 0, most, most}));
  EXPECT_EQ(sorted({-2, -1, -2}), (Numbers{-2, -2, -1}));
  EXPECT_GT(reference::partition_middle(least, most), least);
}

TEST(PartitionSort, RandomArrays) {
  scenes::Random random(20040301);
  for (int trial = 0; trial < 300; ++trial) {
    const Numbers values = random_numbers(random, random.below(200));
    ASSERT_EQ(sorted(values), sorted_by_the_library(values)) << "seed 20040301, trial " << trial;
  }
}

TEST(PartitionSort, CompanionArraysMoveTogetherAndBreakTies) {
  scenes::Random random(20040302);
  for (int trial = 0; trial < 100; ++trial) {
    const std::size_t size = random.below(200);
    Numbers x = random_numbers(random, size);
    Numbers y = random_numbers(random, size);
    Numbers element(size);
    std::iota(element.begin(), element.end(), 0);
    std::shuffle(element.begin(), element.end(), random);

    std::vector<std::array<std::int32_t, 3>> expected(size);
    for (std::size_t k = 0; k < size; ++k) expected[k] = {x[k], y[k], element[k]};
    std::sort(expected.begin(), expected.end());

    reference::CompanionArrays<3>({std::span(x), std::span(y), std::span(element)})
        .sort(0, size, work);
    for (std::size_t k = 0; k < size; ++k) {
      ASSERT_EQ((std::array{x[k], y[k], element[k]}), expected[k])
          << "seed 20040302, trial " << trial << ", position " << k;
    }
  }
}

TEST(PartitionSort, ExchangeTellsWhereTheRightBegins) {
  Numbers values{5, 1, 4, 2, 3};
  reference::CompanionArrays<1> arrays({std::span(values)});
  EXPECT_EQ(arrays.exchange(0, 5, 0, 0, work), 0u);
  EXPECT_EQ(arrays.exchange(0, 5, 0, 6, work), 5u);
  EXPECT_EQ(arrays.exchange(1, 3, 0, 2, work), 2u);
  EXPECT_EQ(values, (Numbers{5, 1, 4, 2, 3})) << "outside [first, last) nothing may move";
  EXPECT_EQ(arrays.exchange(0, 5, 0, 3, work), 2u);
  EXPECT_LT(std::max(values[0], values[1]), 3);
}

/// Sorts on a thread with a small stack: recursion as deep as the array is long would overflow it.
void sort_on_a_small_stack(Numbers& values) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, std::size_t{512} << 10), 0);
  pthread_t thread;
  const auto body = [](void* argument) -> void* {
    auto& numbers = *static_cast<Numbers*>(argument);
    reference::CompanionArrays<1>({std::span(numbers)}).sort(0, numbers.size(), work);
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, body, &values), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

TEST(PartitionSort, RecursionIsNoDeeperThanTheBitsOfTheValues) {
  // Powers of two halve the range as unevenly as values can: each split takes off one of them.
  Numbers values;
  for (int k = 0; k < 200000; ++k) values.push_back(std::int32_t{1} << (k % 31));
  Numbers expected = sorted_by_the_library(values);
  sort_on_a_small_stack(values);
  EXPECT_EQ(values, expected);

  Numbers rising(200000);
  std::iota(rising.begin(), rising.end(), 0);
  Numbers falling(rising.rbegin(), rising.rend());
  sort_on_a_small_stack(falling);
  EXPECT_EQ(falling, rising);
}

}  // namespace
}  // namespace abut::testing
