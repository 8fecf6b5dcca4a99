// Rows of pairs sorted in vectors against std::sort.

#include "kernels/order_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

constexpr std::uint32_t longest = kernels::longest_sorted_row;

/// Stands behind the last row: pairs of others, which stay as they are.
constexpr ContactPair of_others{7, 77};

/// Pairs that lie together row by row, and where their rows end.
struct Rows {
  ElementIndex first_element;
  std::vector<ContactPair> pairs;
  std::vector<std::uint32_t> ends;

  /// Adds a row of pairs whose second elements are below `partners`.
  void add(Random& random, std::uint32_t size, std::uint64_t partners) {
    const auto first = first_element + static_cast<ElementIndex>(ends.size());
    for (std::uint32_t k = 0; k < size; ++k) {
      pairs.push_back({first, static_cast<ElementIndex>(random.below(partners))});
    }
    ends.push_back(static_cast<std::uint32_t>(pairs.size()));
  }
};

std::vector<ContactPair> sorted_by_std(const Rows& rows) {
  std::vector<ContactPair> sorted = rows.pairs;
  std::sort(sorted.begin(), sorted.end());
  sorted.resize(sorted.size() + longest, of_others);
  return sorted;
}

/// Both elements of a pair: words of one row have the same upper half.
std::uint64_t word_of(const ContactPair& pair) {
  return std::uint64_t{pair.first} << 32 | pair.second;
}

std::vector<std::uint64_t> words_of(const std::vector<ContactPair>& pairs) {
  std::vector<std::uint64_t> words(pairs.size());
  std::transform(pairs.begin(), pairs.end(), words.begin(), word_of);
  return words;
}

std::vector<ContactPair> sorted_by(Simd level, const Rows& rows) {
  std::vector<ContactPair> readable = rows.pairs;
  readable.resize(readable.size() + longest);
  std::vector<ContactPair> sorted(readable.size(), of_others);
  kernels::order_kernels(level).sort_pairs({{readable.data(), rows.pairs.size(), rows.ends.data(),
                                             static_cast<std::uint32_t>(rows.ends.size())},
                                            rows.first_element},
                                           sorted.data());
  return sorted;
}

std::vector<std::uint64_t> sorted_words_by(Simd level, const Rows& rows) {
  std::vector<std::uint64_t> readable = words_of(rows.pairs);
  readable.resize(readable.size() + longest);
  std::vector<std::uint64_t> sorted(readable.size(), word_of(of_others));
  kernels::order_kernels(level).sort_words({readable.data(), rows.pairs.size(), rows.ends.data(),
                                            static_cast<std::uint32_t>(rows.ends.size())},
                                           sorted.data());
  return sorted;
}

void expect_sorted(const Rows& rows) {
  const std::vector<ContactPair> expected = sorted_by_std(rows);
  for (const Simd level : simd_levels_here()) {
    const kernels::OrderKernels kernels = kernels::order_kernels(level);
    const auto which = [&] {
      return std::string(name_of(level)) + ", " + std::to_string(rows.ends.size()) + " rows of " +
             std::to_string(rows.pairs.size());
    };
    if (kernels.sort_pairs != nullptr) {
      EXPECT_TRUE(sorted_by(level, rows) == expected) << which();
    }
    if (kernels.sort_words != nullptr) {
      EXPECT_TRUE(sorted_words_by(level, rows) == words_of(expected)) << which();
    }
  }
}

TEST(OrderKernels, LevelsThatSort) {
  for (const Simd level : simd_levels_here()) {
    const kernels::OrderKernels kernels = kernels::order_kernels(level);
    EXPECT_EQ(kernels.sort_pairs != nullptr, level != Simd::scalar) << name_of(level);
    const bool is_wide = level == Simd::avx2 || level == Simd::avx512;
    EXPECT_EQ(kernels.sort_words != nullptr, is_wide) << name_of(level);
  }
}

/// Each length alone, as the last row, and before a short one; partners of all sizes, and so few
/// that pairs are equal.
TEST(OrderKernels, SortRowsOfEachLength) {
  Random random(4);
  for (std::uint32_t size = 0; size <= longest; ++size) {
    for (const std::uint64_t partners : {std::uint64_t{3}, std::uint64_t{0xFFFFFFFF}}) {
      for (const std::uint32_t behind : {0U, 1U, 5U}) {
        Rows rows{1000, {}, {}};
        rows.add(random, size, partners);
        if (behind > 0) rows.add(random, behind, partners);
        expect_sorted(rows);
      }
    }
  }
}

TEST(OrderKernels, SortManyRowsOfAnyLength) {
  Random random(5);
  for (const std::uint64_t most : {2U, 5U, 9U, 17U, 33U, longest + 1}) {
    for (int round = 0; round < 20; ++round) {
      Rows rows{static_cast<ElementIndex>(random.below(0xFFFF0000)), {}, {}};
      for (int row = 0; row < 60; ++row) {
        rows.add(random, static_cast<std::uint32_t>(random.below(most)), 0xFFFFFFFF);
      }
      expect_sorted(rows);
    }
  }
}

TEST(OrderKernels, NoRowsAndEmptyRows) {
  Random random(6);
  Rows rows{0, {}, {}};
  expect_sorted(rows);
  for (int row = 0; row < 5; ++row) rows.add(random, 0, 1);
  expect_sorted(rows);
}

}  // namespace
}  // namespace abut::testing
