#include "lists/ordered_rows.hpp"

#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

NobodyAsked nobody;

/// Pairs in canonical order, many elements without any, and a shift for each that tells its place.
struct OrderedPairs {
  OrderedPairs(std::size_t elements, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    for (std::size_t k = 0; k < count; ++k) {
      pairs.push_back({static_cast<ElementIndex>(random.below(elements)),
                       static_cast<ElementIndex>(random.below(elements))});
    }
    std::sort(pairs.begin(), pairs.end());
    for (std::size_t k = 0; k < count; ++k) shifts.push_back({static_cast<std::int32_t>(k), 0, 1});
  }

  std::vector<ContactPair> pairs;
  std::vector<ImageShift> shifts;
};

/// The same in pieces of any length, empty ones among them.
struct Pieces {
  Pieces(const OrderedPairs& ordered, std::uint64_t seed) {
    Random random(seed);
    const std::span<const ContactPair> pairs(ordered.pairs);
    for (std::size_t begin = 0; begin < pairs.size();) {
      const std::size_t count = std::min<std::size_t>(random.below(9), pairs.size() - begin);
      of_pairs.push_back(pairs.subspan(begin, count));
      of_shifts.push_back(std::span(ordered.shifts).subspan(begin, count));
      begin += count;
    }
  }

  std::vector<std::span<const ContactPair>> of_pairs;
  std::vector<std::span<const ImageShift>> of_shifts;
};

TEST(OrderedRows, AreThePairsRowByRow) {
  for (const std::size_t elements : {1U, 2U, 50U, 1000U}) {
    for (const std::size_t count : {0U, 1U, 7U, 300U}) {
      const OrderedPairs ordered(elements, count, elements + count);
      const Pieces pieces(ordered, count);
      for (const std::size_t workers : {1U, 2U, 7U}) {
        std::vector<PairCount> offsets(elements + 1, 12345);
        std::vector<ElementIndex> neighbors(count, 12345);
        std::vector<ImageShift> shifts(count);
        lists::list_ordered_rows({pieces.of_pairs, pieces.of_shifts}, {offsets, neighbors, shifts},
                                 workers, nobody.work);
        ASSERT_EQ(shifts, ordered.shifts);
        ASSERT_EQ(offsets[0], 0U);
        ASSERT_EQ(offsets[elements], count);
        for (std::size_t e = 0; e < elements; ++e) {
          for (PairCount k = offsets[e]; k < offsets[e + 1]; ++k) {
            ASSERT_EQ(ordered.pairs[k], (ContactPair{static_cast<ElementIndex>(e), neighbors[k]}));
          }
        }
      }
    }
  }
}

TEST(OrderedRows, WithoutShifts) {
  const OrderedPairs ordered(20, 40, 3);
  const Pieces pieces(ordered, 4);
  std::vector<PairCount> offsets(21);
  std::vector<ElementIndex> neighbors(40);
  lists::list_ordered_rows({pieces.of_pairs}, {offsets, neighbors}, 2, nobody.work);
  for (std::size_t k = 0; k < 40; ++k) EXPECT_EQ(neighbors[k], ordered.pairs[k].second);
}

TEST(OrderedRows, OfNoElements) {
  std::vector<PairCount> offsets(1, 12345);
  lists::list_ordered_rows({}, {offsets, {}}, 1, nobody.work);
  EXPECT_EQ(offsets[0], 0U);
}

}  // namespace
}  // namespace abut::testing
