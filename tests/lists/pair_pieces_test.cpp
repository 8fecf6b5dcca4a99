// From pairs as several workers found them to lists: FoundPairs, join, canonical order, rows of
// neighbors.

#include "kernels/order_kernels.hpp"
#include "lists/csr_builder.hpp"
#include "lists/found_pairs.hpp"
#include "lists/order_pairs.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"
#include "support/oracle.hpp"

#include <abut/error.hpp>
#include <abut/simd.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
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
using testing::PairVector;

constexpr std::size_t elements = 5000;

testing::NobodyAsked nobody;

/// Any shift that tells the pair.
ImageShift shift_of(const ContactPair& pair) {
  return {static_cast<std::int32_t>(pair.first), -static_cast<std::int32_t>(pair.second), 7};
}

/// Units of pairs, found by workers in any order; each unit's pairs in one worker, in several
/// commits.
struct Units {
  std::vector<PairVector> pairs;

  explicit Units(std::uint64_t seed) {
    Random random(seed);
    for (std::size_t unit = 0; unit < 60; ++unit) {
      PairVector here(random.below(10) == 0 ? 20000 : random.below(300));
      for (ContactPair& pair : here) {
        pair.first = static_cast<ElementIndex>(random.below(elements - 1));
        pair.second =
            static_cast<ElementIndex>(pair.first + 1 + random.below(elements - 1 - pair.first));
      }
      pairs.push_back(std::move(here));
    }
    // Each pair once, as detections find them.
    std::set<ContactPair> seen;
    for (PairVector& unit : pairs) {
      std::erase_if(unit, [&](const ContactPair& pair) { return !seen.insert(pair).second; });
    }
  }

  [[nodiscard]] PairVector together() const {
    PairVector result;
    for (const PairVector& unit : pairs) result.insert(result.end(), unit.begin(), unit.end());
    return result;
  }

  void deliver(lists::FoundPairs& found, std::size_t workers, std::uint64_t seed) const {
    Random random(seed);
    found.expect_workers(workers);
    std::vector<std::size_t> order(pairs.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    for (std::size_t left = order.size(); left > 1; --left) {
      std::swap(order[left - 1], order[random.below(left)]);
    }
    for (const std::size_t unit : order) {
      deliver_unit(found, unit, random.below(workers), random);
    }
  }

  void deliver_in_order(lists::FoundPairs& found) const {
    Random random(1);
    found.expect_workers(1);
    for (std::size_t unit = 0; unit < pairs.size(); ++unit) deliver_unit(found, unit, 0, random);
  }

  void deliver_unit(lists::FoundPairs& found, std::size_t unit, std::size_t worker,
                    Random& random) const {
    for (std::size_t done = 0; done < pairs[unit].size();) {
      const auto room = found.buffer(worker);
      ASSERT_GE(room.size(), base::PairSink::smallest_buffer);
      const std::size_t count =
          std::min({room.size(), pairs[unit].size() - done, 1 + random.below(5000)});
      const std::span piece = std::span(pairs[unit]).subspan(done, count);
      std::copy(piece.begin(), piece.end(), room.begin());
      const auto shifts = found.shift_buffer(worker);
      if (!shifts.empty()) {
        ASSERT_GE(shifts.size(), count);
        std::transform(piece.begin(), piece.end(), shifts.begin(), shift_of);
      }
      found.commit(count, {worker, unit});
      done += count;
    }
  }
};

PairVector joined(lists::FoundPairs& found, std::size_t workers) {
  const auto pieces = found.pieces();
  PairVector result(found.size());
  base::MemoryMeter memory;
  lists::PairOrder(memory).join(pieces, {result, {}}, workers, nobody.work);
  return result;
}

TEST(FoundPairs, ComeInTheOrderOfUnitsWhoeverFoundThem) {
  const Units units(1);
  for (const std::size_t workers : {1U, 2U, 7U}) {
    base::MemoryMeter memory;
    lists::FoundPairs found(memory);
    for (std::uint64_t seed = 2; seed < 5; ++seed) {
      found.start_anew({});
      units.deliver(found, workers, seed);
      EXPECT_EQ(joined(found, workers), units.together());
    }
  }
}

TEST(FoundPairs, KeepTheirMemoryAndGiveItBackAtTheEnd) {
  const Units units(1);
  base::MemoryMeter memory;
  {
    lists::FoundPairs found(memory);
    units.deliver(found, 2, 3);
    const std::uint64_t held = memory.held();
    EXPECT_GE(held, found.size() * sizeof(ContactPair));
    found.start_anew({});
    EXPECT_EQ(found.size(), 0U);
    EXPECT_EQ(found.pieces().size(), 0U);
    units.deliver(found, 2, 3);
    EXPECT_EQ(memory.held(), held);
  }
  EXPECT_EQ(memory.held(), 0U);
}

/// A single worker's, in ascending units: whatever does not fit into the room goes to chunks.
TEST(FoundPairs, OfOneWorkerStandWhereTheyAreWanted) {
  const Units units(1);
  const PairVector expected = units.together();
  for (const std::size_t room : {std::size_t{0}, std::size_t{511}, std::size_t{5000},
                                 expected.size(), expected.size() + 1000}) {
    base::MemoryMeter memory;
    lists::FoundPairs found(memory);
    PairVector target(std::max(room, expected.size()));
    found.start_anew({.buffer = {std::span(target).first(room), {}}});
    units.deliver_in_order(found);
    const std::size_t in_place = found.in_buffer();
    EXPECT_LE(in_place, room);
    EXPECT_GE(in_place + base::PairSink::smallest_buffer, std::min(room, expected.size()));
    target.resize(expected.size());
    lists::PairOrder(memory).join(found.pieces(), {target, {}}, 1, nobody.work, in_place);
    EXPECT_EQ(target, expected) << "room for " << room;
  }
}

/// Shifts too, as far as there is room for both.
TEST(FoundPairs, OfOneWorkerStandWithTheirShiftsWhereTheyAreWanted) {
  const Units units(1);
  const PairVector expected = units.together();
  const std::size_t all = expected.size();
  std::vector<ImageShift> expected_shifts(all);
  std::transform(expected.begin(), expected.end(), expected_shifts.begin(), shift_of);
  for (const auto& [room, room_for_shifts] :
       {std::pair{all, all}, {all, std::size_t{5000}}, {std::size_t{5000}, all}, {all, {}}}) {
    base::MemoryMeter memory;
    lists::FoundPairs found(memory);
    PairVector target(all);
    std::vector<ImageShift> shifts(all);
    found.start_anew(
        {.shifts = Shifts::stored,
         .buffer = {std::span(target).first(room), std::span(shifts).first(room_for_shifts)}});
    units.deliver_in_order(found);
    const std::size_t in_place = found.in_buffer();
    const std::size_t lent = std::min(room, room_for_shifts);
    EXPECT_LE(in_place, lent);
    EXPECT_GE(in_place + base::PairSink::smallest_buffer, lent);
    lists::PairOrder(memory).join(found.pieces(), {target, shifts}, 1, nobody.work, in_place);
    EXPECT_EQ(target, expected) << "room for " << room << " and " << room_for_shifts;
    EXPECT_EQ(shifts, expected_shifts) << "room for " << room << " and " << room_for_shifts;
  }
}

TEST(FoundPairs, OfSeveralWorkersDoNot) {
  const Units units(1);
  base::MemoryMeter memory;
  lists::FoundPairs found(memory);
  PairVector target(units.together().size());
  found.start_anew({.buffer = {target, {}}});
  units.deliver(found, 2, 3);
  EXPECT_EQ(found.in_buffer(), 0U);
  EXPECT_EQ(joined(found, 2), units.together());
}

TEST(FoundPairs, OneMoreThanTheLimitIsAnError) {
  base::MemoryMeter memory;
  lists::FoundPairs found(memory);
  found.start_anew({.limit = 100});
  found.expect_workers(2);
  static_cast<void>(found.buffer(0));
  found.commit(60, {0, 0});
  static_cast<void>(found.buffer(1));
  found.commit(40, {1, 1});
  static_cast<void>(found.buffer(0));
  EXPECT_THROW(found.commit(1, {0, 2}), Error);
}

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

/// Rows as short as those of contacts, which vectors sort; few and many that are as long as they
/// take, longer by one, and much longer.
TEST(OrderPairs, RowsOfEachLengthOnEveryLevel) {
  constexpr ElementIndex count = 10000;
  Random random(9);
  for (const std::size_t longest : {64U, 65U, 500U}) {
    for (const ElementIndex between : {5U, 100U, 5000U}) {
      const PairVector pairs = rows_of_pairs(random, count, between, longest);
      PairVector expected = pairs;
      std::sort(expected.begin(), expected.end());
      const std::span<const ContactPair> piece(pairs);
      for (const Simd level : simd_levels()) {
        if (!available(level)) continue;
        base::MemoryMeter memory;
        PairVector ordered(pairs.size());
        lists::PairOrder order(memory);
        order.use(kernels::order_kernels(level));
        order.sort({{&piece, 1}}, count, {ordered, {}}, 2, nobody.work);
        EXPECT_TRUE(ordered == expected) << name_of(level) << ' ' << longest << ' ' << between;
      }
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
