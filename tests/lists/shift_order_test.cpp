// Pairs and rows in order with their image shifts, which are packed meanwhile where they are short.

#include "base/memory_meter.hpp"
#include "base/opposite_shift.hpp"
#include "base/progress_reporter.hpp"
#include "lists/csr_builder.hpp"
#include "lists/found_pairs.hpp"
#include "lists/order_pairs.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"
#include "support/oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

NobodyAsked nobody;

/// Many images of the same pairs, as small periodic cells have them, too, in two pieces.
struct ManyImages {
  /// Numbers of shifts are less than `longest` by magnitude, but that of the last pair is that.
  ManyImages(ElementIndex count, std::int32_t longest) {
    const std::int32_t widest = std::abs(longest);
    Random random(9);
    const auto add = [&](const ImageShift& shift) {
      const auto first = static_cast<ElementIndex>(random.below(count - 1));
      const ContactPair pair{first, static_cast<ElementIndex>(first + random.below(2))};
      if (!entries.insert({pair, shift}).second) return;
      pairs.push_back(pair);
      shifts.push_back(shift);
    };
    const std::uint64_t numbers = 2 * static_cast<std::uint64_t>(widest) - 1;
    const auto number = [&] {
      return static_cast<std::int32_t>(static_cast<std::int64_t>(random.below(numbers)) - widest +
                                       1);
    };
    while (pairs.size() < 8000) add({number(), number(), number()});
    add({number(), longest, number()});
  }

  [[nodiscard]] lists::FoundPieces pieces() {
    pair_pieces = {std::span<const ContactPair>(pairs).first(1000),
                   std::span<const ContactPair>(pairs).subspan(1000)};
    shift_pieces = {std::span<const ImageShift>(shifts).first(1000),
                    std::span<const ImageShift>(shifts).subspan(1000)};
    return {pair_pieces, shift_pieces};
  }

  std::set<std::pair<ContactPair, ImageShift>> entries;
  PairVector pairs;
  std::vector<ImageShift> shifts;
  std::array<std::span<const ContactPair>, 2> pair_pieces;
  std::array<std::span<const ImageShift>, 2> shift_pieces;
};

/// Shifts up to 15 are packed with their pairs while these are sorted, longer ones are not.
constexpr std::int32_t any_shift = std::numeric_limits<std::int32_t>::max();
constexpr std::array longest_shifts{15, -15, 16, -16, 17, -20, any_shift, -any_shift};

TEST(OrderPairs, ShiftsFollowTheirPairsAndDecideAmongEqualOnes) {
  for (const ElementIndex count : {2U, 5000U}) {
    for (const std::int32_t longest : longest_shifts) {
      SCOPED_TRACE(std::to_string(count) + " elements, longest shift " + std::to_string(longest));
      ManyImages given(count, longest);
      base::MemoryMeter memory;
      PairVector ordered(given.pairs.size());
      std::vector<ImageShift> shifts(given.pairs.size());
      lists::PairOrder(memory).sort(given.pieces(), count, {ordered, shifts}, 2, nobody.work);
      std::size_t k = 0;
      for (const auto& [pair, shift] : given.entries) {
        ASSERT_EQ(ordered[k], pair) << k;
        ASSERT_EQ(shifts[k++], shift) << k;
      }
    }
  }
}

TEST(CsrBuilder, ShiftsFollowTheirNeighborsAndAreOppositeFromTheOtherEnd) {
  for (const ElementIndex count : {2U, 5000U}) {
    for (const std::int32_t longest : longest_shifts) {
      SCOPED_TRACE(std::to_string(count) + " elements, longest shift " + std::to_string(longest));
      ManyImages given(count, longest);
      std::multiset<std::pair<ContactPair, ImageShift>> expected;
      for (const auto& [pair, shift] : given.entries) {
        expected.insert({pair, shift});
        expected.insert({{pair.second, pair.first}, base::opposite(shift)});
      }
      base::MemoryMeter memory;
      std::vector<PairCount> offsets(count + 1);
      std::vector<ElementIndex> neighbors(expected.size());
      std::vector<ImageShift> shifts(expected.size());
      lists::CsrBuilder(memory).list(given.pieces(), NeighborListKind::full,
                                     {offsets, neighbors, shifts}, 2, nobody.work);
      std::size_t k = 0;
      for (const auto& [entry, shift] : expected) {
        ASSERT_GE(k, offsets[entry.first]);
        ASSERT_LT(k, offsets[entry.first + 1]);
        ASSERT_EQ(neighbors[k], entry.second) << k;
        ASSERT_EQ(shifts[k++], shift) << k;
      }
    }
  }
}

/// Pairs of elements numbered anyhow; the hook is asked every 2^16 steps.
TEST(OrderPairs, PackedPairsTakeNoMoreStepsThanOthers) {
  constexpr ElementIndex count = 200000;
  const auto questions = [](std::int32_t shift) {
    Random random(4);
    PairVector pairs(3 * count);
    for (ContactPair& pair : pairs) {
      pair.first = static_cast<ElementIndex>(random.below(count - 1));
      pair.second =
          pair.first + 1 + static_cast<ElementIndex>(random.below(count - 1 - pair.first));
    }
    const std::vector<ImageShift> shifts(pairs.size(), ImageShift{shift, 0, 0});
    const std::array pieces{std::span<const ContactPair>(pairs)};
    const std::array shift_pieces{std::span<const ImageShift>(shifts)};
    std::size_t calls = 0;
    const ProgressHook hook = [&](const Progress&) {
      ++calls;
      return ProgressAction::proceed;
    };
    base::ProgressReporter progress(hook);
    base::WorkCounter work(progress, 0);
    base::MemoryMeter memory;
    PairVector ordered(pairs.size());
    std::vector<ImageShift> ordered_shifts(pairs.size());
    lists::PairOrder(memory).sort({pieces, shift_pieces}, count, {ordered, ordered_shifts}, 1,
                                  work);
    EXPECT_TRUE(std::ranges::is_sorted(ordered));
    return calls;
  };
  const std::size_t of_others = questions(16);
  EXPECT_GT(of_others, 50U);
  EXPECT_LE(questions(15), of_others + of_others / 8);
}

}  // namespace
}  // namespace abut::testing
