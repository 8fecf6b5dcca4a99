// From pairs as several workers found them to lists: canonical order, rows of neighbors.

#include "kernels/order_kernels.hpp"
#include "lists/csr_builder.hpp"
#include "lists/found_pairs.hpp"
#include "lists/order_pairs.hpp"
#include "lists/pair_units.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"
#include "support/oracle.hpp"
#include "support/rows_variants.hpp"

#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::size_t elements = Units::elements;

NobodyAsked nobody;

TEST(OrderPairs, CanonicalIsSorted) {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const Units units(seed);
    PairVector expected = units.together();
    std::sort(expected.begin(), expected.end());
    for (const std::size_t workers : {1U, 2U, 7U}) {
      base::MemoryMeter memory;
      lists::FoundPairs found(memory);
      units.deliver(found, workers, seed);
      const auto pieces = found.pieces();
      PairVector ordered(found.size());
      lists::PairOrder(memory).sort(pieces, elements, {ordered, {}}, workers, nobody.work);
      EXPECT_EQ(ordered, expected) << workers << " workers";
    }
  }
}

/// Pairs whose partners lie near or far in the numbering, few or many for each element, some of
/// them equal, as images of one element are; and now and then an element with a crowd of partners.
PairVector scattered_pairs(Random& random, ElementIndex count, std::size_t pairs,
                           ElementIndex furthest) {
  PairVector result;
  while (result.size() < pairs) {
    const auto first = static_cast<ElementIndex>(random.below(count - furthest));
    const std::size_t partners = random.below(1000) == 0 ? 200 : 1 + random.below(3);
    for (std::size_t k = 0; k < partners; ++k) {
      result.push_back({first, static_cast<ElementIndex>(first + random.below(furthest + 1))});
    }
  }
  return result;
}

/// Of `count` elements, each with up to 7 partners or none, some of them equal; but every so many
/// with `longest` of them.
PairVector rows_of_pairs(Random& random, ElementIndex count, ElementIndex between_long_rows,
                         std::size_t longest) {
  PairVector pairs;
  for (ElementIndex first = 0; first < count; ++first) {
    const bool is_long = first % between_long_rows == between_long_rows - 1;
    const std::size_t partners = is_long ? longest : random.below(8);
    const std::uint64_t furthest = first % 2 == 0 ? 20 : count;
    for (std::size_t k = 0; k < partners; ++k) {
      pairs.push_back({first, static_cast<ElementIndex>(first + random.below(furthest))});
    }
  }
  std::shuffle(pairs.begin(), pairs.end(), random);
  return pairs;
}

/// Brings pairs of `count` elements into canonical order and into rows on every level, and expects
/// what std::sort makes of them.
void expect_order_on_every_level(const PairVector& pairs, ElementIndex count) {
  PairVector expected = pairs;
  std::sort(expected.begin(), expected.end());
  const std::span<const ContactPair> piece(pairs);
  for (const Simd level : simd_levels_here()) {
    base::MemoryMeter memory;
    PairVector ordered(pairs.size());
    lists::PairOrder order(memory);
    order.use(kernels::order_kernels(level));
    order.sort({{&piece, 1}}, count, {ordered, {}}, 2, nobody.work);
    EXPECT_TRUE(ordered == expected) << name_of(level);
    std::vector<PairCount> offsets(count + 1, 12345);
    std::vector<ElementIndex> neighbors(pairs.size());
    lists::CsrBuilder builder(memory);
    builder.use(kernels::order_kernels(level));
    builder.list({{&piece, 1}}, NeighborListKind::half, {offsets, neighbors}, 2, nobody.work);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [first, second] = expected[k];
      ASSERT_EQ(neighbors[k], second) << name_of(level);
      ASSERT_TRUE(offsets[first] <= k && k < offsets[first + 1]) << name_of(level);
    }
    ASSERT_EQ(offsets[count], pairs.size());
  }
}

/// How pairs are sorted in vectors depends on how many there are for each element: 8 slots a row,
/// or twice as many up to 64; and one element in some has twice as many pairs as slots. The last
/// range of elements is empty, has one element, or some.
TEST(OrderPairs, FewAndManySlotsOnEveryLevel) {
  Random random(10);
  for (const ElementIndex count : {1U, 2U, 4096U, 4097U, 9000U}) {
    for (const std::uint64_t most : {5U, 12U, 28U, 60U, 90U}) {
      for (const ElementIndex between : {30U, 1000U}) {
        SCOPED_TRACE(std::to_string(count) + " elements, up to " + std::to_string(most) +
                     " pairs, more for one in " + std::to_string(between));
        PairVector pairs;
        for (ElementIndex first = 0; first < count; ++first) {
          const bool is_long = first % between == between - 1;
          const std::size_t partners = is_long ? 2 * most + 20 : random.below(most + 1);
          for (std::size_t k = 0; k < partners; ++k) {
            pairs.push_back({first, static_cast<ElementIndex>(random.below(count))});
          }
        }
        std::shuffle(pairs.begin(), pairs.end(), random);
        expect_order_on_every_level(pairs, count);
      }
    }
  }
}

/// Rows as short as those of contacts, which vectors sort; few and many that are as long as they
/// take, longer by one, and much longer.
TEST(OrderPairs, RowsOfEachLengthOnEveryLevel) {
  constexpr ElementIndex count = 10000;
  Random random(9);
  for (const std::size_t longest : {64U, 65U, 500U}) {
    for (const ElementIndex between : {5U, 100U, 5000U}) {
      SCOPED_TRACE(std::to_string(longest) + " pairs of one element in " + std::to_string(between));
      expect_order_on_every_level(rows_of_pairs(random, count, between, longest), count);
    }
  }
}

TEST(OrderPairs, FewOrManyPairsOfNearOrFarPartners) {
  constexpr ElementIndex count = 200000;
  Random random(8);
  for (const std::size_t size : {1U, 300U, 20000U, 150000U, 600000U}) {
    for (const ElementIndex furthest : {0U, 3U, 1000U, 100000U}) {
      const PairVector pairs = scattered_pairs(random, count, size, furthest);
      PairVector expected = pairs;
      std::sort(expected.begin(), expected.end());
      const std::span<const ContactPair> piece(pairs);
      base::MemoryMeter memory;
      PairVector ordered(pairs.size());
      lists::PairOrder(memory).sort({{&piece, 1}}, count, {ordered, {}}, 2, nobody.work);
      EXPECT_EQ(ordered, expected) << pairs.size() << " pairs, partners up to " << furthest;
    }
  }
}

/// One element with all others, in reverse: one long row.
TEST(OrderPairs, OneCrowdedElement) {
  constexpr ElementIndex count = 100000;
  PairVector pairs;
  for (ElementIndex k = count; k-- > 1;) pairs.push_back({0, k});
  PairVector expected = pairs;
  std::reverse(expected.begin(), expected.end());
  const std::span<const ContactPair> piece(pairs);
  for (const std::size_t workers : {1U, 3U}) {
    base::MemoryMeter memory;
    PairVector ordered(pairs.size());
    lists::PairOrder(memory).sort({{&piece, 1}}, count, {ordered, {}}, workers, nobody.work);
    EXPECT_EQ(ordered, expected);
  }
}

TEST(OrderPairs, NoPairsNoWork) {
  base::MemoryMeter memory;
  lists::PairOrder order(memory);
  order.sort({}, 0, {}, 2, nobody.work);
  order.sort({}, 10, {}, 2, nobody.work);
  order.join({}, {}, 2, nobody.work);
  EXPECT_EQ(memory.held(), 0U);
}

TEST(CsrBuilder, HoldThePartnersAscending) {
  const Units units(5);
  const PairVector pairs = units.together();
  for (const auto kind : {NeighborListKind::half, NeighborListKind::full}) {
    std::vector<std::vector<ElementIndex>> expected(elements);
    for (const ContactPair& pair : pairs) {
      expected[pair.first].push_back(pair.second);
      if (kind == NeighborListKind::full) expected[pair.second].push_back(pair.first);
    }
    for (auto& row : expected) std::sort(row.begin(), row.end());
    // In two pieces, so that workers share them.
    const std::span<const ContactPair> all(pairs);
    const std::array pieces{all.first(1000), all.subspan(1000)};
    for (const std::size_t workers : {1U, 2U, 7U}) {
      base::MemoryMeter memory;
      std::vector<PairCount> offsets(elements + 1, 12345);
      std::vector<ElementIndex> neighbors(pairs.size() * (kind == NeighborListKind::full ? 2 : 1));
      lists::CsrBuilder(memory).list({pieces}, kind, {offsets, neighbors}, workers, nobody.work);
      ASSERT_EQ(offsets[0], 0U);
      ASSERT_EQ(offsets[elements], neighbors.size());
      for (std::size_t e = 0; e < elements; ++e) {
        ASSERT_TRUE(std::equal(expected[e].begin(), expected[e].end(),
                               neighbors.begin() + static_cast<std::ptrdiff_t>(offsets[e]),
                               neighbors.begin() + static_cast<std::ptrdiff_t>(offsets[e + 1])));
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
