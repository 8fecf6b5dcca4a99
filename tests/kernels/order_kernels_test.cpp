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

/// Both elements of a pair: words of one row have the same upper half.
std::uint64_t word_of(const ContactPair& pair) {
  return std::uint64_t{pair.first} << 32 | pair.second;
}

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

  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(ends.size()); }
  [[nodiscard]] std::uint32_t begin(std::size_t row) const { return row == 0 ? 0 : ends[row - 1]; }
};

/// The numbers of the rows in slots, of which a row may have too few.
template <class Number>
struct Slots {
  std::vector<Number> numbers;
  std::vector<std::uint32_t> sizes;
  std::uint32_t capacity;

  template <class NumberOf>
  Slots(const Rows& rows, std::uint32_t slots, const NumberOf& number_of)
      : numbers(std::size_t{slots} * rows.count() + longest), capacity(slots) {
    for (std::uint32_t row = 0; row < rows.count(); ++row) {
      const std::uint32_t begin = rows.begin(row);
      sizes.push_back(rows.ends[row] - begin);
      for (std::uint32_t k = 0; k < std::min(sizes[row], slots); ++k) {
        numbers[std::size_t{slots} * row + k] = number_of(rows.pairs[begin + k]);
      }
    }
  }

  [[nodiscard]] kernels::RowSlots<Number> view(const Rows& rows) const {
    return {numbers.data(), sizes.data(), rows.count(), capacity, rows.pairs.size()};
  }
};

/// What must come of rows, of each of which `slots` pairs have a slot: every row sorted, and of
/// longer ones those pairs alone, in their order among themselves, before room for the others.
std::vector<ContactPair> sorted_by_std(const Rows& rows, std::uint32_t slots) {
  std::vector<ContactPair> sorted = rows.pairs;
  for (std::size_t row = 0; row < rows.count(); ++row) {
    const auto first = sorted.begin() + rows.begin(row);
    const auto last = sorted.begin() + rows.ends[row];
    std::sort(first, first + std::min<std::ptrdiff_t>(last - first, slots));
    if (last - first > slots) std::fill(first + slots, last, of_others);
  }
  sorted.resize(sorted.size() + longest, of_others);
  return sorted;
}

/// Pairs without a slot replaced, and the others of their rows sorted, since kernels leave both as
/// they like.
template <class Entry>
std::vector<Entry> without_excess(std::vector<Entry> sorted, const Rows& rows, std::uint32_t slots,
                                  Entry other) {
  for (std::size_t row = 0; row < rows.count(); ++row) {
    const auto first = sorted.begin() + rows.begin(row);
    const auto last = sorted.begin() + rows.ends[row];
    if (last - first <= slots) continue;
    std::sort(first, first + slots);
    std::fill(first + slots, last, other);
  }
  return sorted;
}

template <class To, class Make>
std::vector<To> made_of(const std::vector<ContactPair>& pairs, const Make& make) {
  std::vector<To> result(pairs.size());
  std::transform(pairs.begin(), pairs.end(), result.begin(), make);
  return result;
}

void expect_sorted_slots(const Rows& rows, std::uint32_t slots) {
  const std::vector<ContactPair> expected = sorted_by_std(rows, slots);
  const auto second_of = [](const ContactPair& pair) { return pair.second; };
  const Slots<std::uint32_t> numbers(rows, slots, second_of);
  const Slots<std::uint64_t> words(rows, slots, word_of);
  for (const Simd level : simd_levels_here()) {
    const kernels::OrderKernels kernels = kernels::order_kernels(level);
    const auto which = [&] {
      return std::string(name_of(level)) + ", " + std::to_string(rows.count()) + " rows of " +
             std::to_string(rows.pairs.size()) + " in " + std::to_string(slots) + " slots each";
    };
    if (kernels.sort_pairs != nullptr) {
      std::vector<ContactPair> sorted(expected.size(), of_others);
      kernels.sort_pairs(numbers.view(rows), rows.first_element, sorted.data());
      EXPECT_TRUE(without_excess(sorted, rows, slots, of_others) == expected) << which();
    }
    if (kernels.sort_numbers != nullptr) {
      std::vector<std::uint32_t> sorted(expected.size(), of_others.second);
      kernels.sort_numbers(numbers.view(rows), sorted.data());
      EXPECT_TRUE(without_excess(sorted, rows, slots, of_others.second) ==
                  made_of<std::uint32_t>(expected, second_of))
          << which();
    }
    if (kernels.sort_words != nullptr) {
      std::vector<std::uint64_t> sorted(expected.size(), word_of(of_others));
      kernels.sort_words(words.view(rows), sorted.data());
      EXPECT_TRUE(without_excess(sorted, rows, slots, word_of(of_others)) ==
                  made_of<std::uint64_t>(expected, word_of))
          << which();
    }
  }
}

void expect_sorted_rows(const Rows& rows) {
  const auto expected = made_of<std::uint64_t>(sorted_by_std(rows, longest), word_of);
  std::vector<std::uint64_t> readable = made_of<std::uint64_t>(rows.pairs, word_of);
  readable.resize(readable.size() + longest);
  for (const Simd level : simd_levels_here()) {
    const kernels::OrderKernels kernels = kernels::order_kernels(level);
    if (kernels.sort_word_rows == nullptr) continue;
    std::vector<std::uint64_t> sorted(readable.size(), word_of(of_others));
    kernels.sort_word_rows({readable.data(), rows.ends.data(), rows.count(), rows.pairs.size()},
                           sorted.data());
    EXPECT_TRUE(sorted == expected)
        << name_of(level) << ", " << rows.count() << " rows of " << rows.pairs.size();
  }
}

/// Rows of at most `longest` pairs.
void expect_sorted(const Rows& rows) {
  for (const std::uint32_t slots : {8U, 16U, 32U, longest}) expect_sorted_slots(rows, slots);
  expect_sorted_rows(rows);
}

TEST(OrderKernels, LevelsThatSort) {
  for (const Simd level : simd_levels_here()) {
    const kernels::OrderKernels kernels = kernels::order_kernels(level);
    EXPECT_EQ(kernels.sort_pairs != nullptr, level != Simd::scalar) << name_of(level);
    const bool is_wide = level == Simd::avx2 || level == Simd::avx512;
    EXPECT_EQ(kernels.sort_numbers != nullptr, level != Simd::scalar) << name_of(level);
    EXPECT_EQ(kernels.sort_words != nullptr, is_wide) << name_of(level);
    EXPECT_EQ(kernels.sort_word_rows != nullptr, is_wide) << name_of(level);
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

/// Between rows that have slots enough, some that are longer than vectors take.
TEST(OrderKernels, RowsWithoutSlotsEnoughLeaveRoom) {
  Random random(7);
  for (const std::uint32_t size : {9U, 65U, 300U}) {
    Rows rows{50, {}, {}};
    for (int row = 0; row < 40; ++row) {
      rows.add(random, row % 7 == 3 ? size : static_cast<std::uint32_t>(random.below(9)), 1000);
    }
    for (const std::uint32_t slots : {8U, 16U, 32U, longest}) expect_sorted_slots(rows, slots);
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
