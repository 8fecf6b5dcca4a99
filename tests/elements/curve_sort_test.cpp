// Elements in the order of their numbers along a curve, whatever these have in common.

#include "elements/curve_sort.hpp"

#include "base/memory_meter.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;
using Numbers = std::vector<std::uint64_t>;

std::vector<ElementIndex> sorted(const Numbers& numbers, std::size_t workers) {
  base::MemoryMeter memory;
  NobodyAsked nobody;
  elements::CurveSort sort(memory, numbers.size(), workers);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    sort.places()[k] = {numbers[k], static_cast<ElementIndex>(k)};
  }
  std::vector<ElementIndex> order(numbers.size());
  sort.write_order(order, nobody.work);
  return order;
}

void expect_sorted(const Numbers& numbers) {
  std::vector<ElementIndex> expected(numbers.size());
  for (std::size_t k = 0; k < numbers.size(); ++k) expected[k] = static_cast<ElementIndex>(k);
  std::ranges::stable_sort(expected, {}, [&](ElementIndex k) { return numbers[k]; });
  for (const std::size_t workers : {1U, 2U, 7U}) {
    EXPECT_TRUE(sorted(numbers, workers) == expected)
        << numbers.size() << " numbers, " << workers << " workers";
  }
}

/// A few, more than a few, and as many as all workers divide, several times over.
void expect_sorted_of_all_sizes(const std::function<std::uint64_t(std::size_t)>& number) {
  for (const std::size_t size : {0U, 1U, 2U, 24U, 25U, 1000U, 32767U, 32768U, 200000U}) {
    Numbers numbers(size);
    for (std::size_t k = 0; k < size; ++k) numbers[k] = number(k);
    expect_sorted(numbers);
  }
}

TEST(CurveSort, NumbersAtRandom) {
  Random random(61);
  expect_sorted_of_all_sizes([&](std::size_t) { return random.next() >> 1; });
}

TEST(CurveSort, NumbersOfFewBits) {
  Random random(62);
  for (const int bits : {1, 3, 8, 11, 12, 19, 22, 40}) {
    expect_sorted_of_all_sizes([&](std::size_t) { return random.next() >> (64 - bits); });
    expect_sorted_of_all_sizes(
        [&](std::size_t) { return random.next() >> (64 - bits) << (63 - bits); });
  }
}

TEST(CurveSort, AllInOnePlace) {
  for (const std::uint64_t one : {std::uint64_t{0}, std::uint64_t{12345}, ~std::uint64_t{0} >> 1}) {
    expect_sorted_of_all_sizes([&](std::size_t) { return one; });
  }
}

/// Most share all leading bits with each other, and a few strays share none.
TEST(CurveSort, CrowdsAndStrays) {
  Random random(63);
  for (const int bits : {2, 10, 30, 50}) {
    expect_sorted_of_all_sizes([&](std::size_t k) {
      const std::uint64_t number = random.next() >> 1;
      return k % 5000 == 4 ? number : number >> (63 - bits);
    });
  }
}

TEST(CurveSort, NumbersInOrderAndAgainstIt) {
  expect_sorted_of_all_sizes([](std::size_t k) { return k * 7919; });
  expect_sorted_of_all_sizes([](std::size_t k) { return (std::uint64_t{1} << 40) - k / 3; });
}

}  // namespace
}  // namespace abut::testing
