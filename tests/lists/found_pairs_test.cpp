// Pairs as several workers find them: in chunks, in the list, in the order of their units.

#include "lists/found_pairs.hpp"
#include "base/progress_reporter.hpp"
#include "lists/list_buffer.hpp"
#include "lists/order_pairs.hpp"
#include "lists/pair_units.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"
#include "support/oracle.hpp"

#include <abut/error.hpp>
#include <abut/pair_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

NobodyAsked nobody;

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

/// A list that some call filled before, and that has room for so many pairs and shifts.
struct UsedList {
  PairArray pairs;
  ShiftArray shifts;

  UsedList(std::size_t room, std::size_t room_for_shifts) {
    pairs.reserve(room);
    shifts.reserve(room_for_shifts);
  }

  [[nodiscard]] std::size_t room(Shifts stored) const {
    return stored == Shifts::stored ? std::min(pairs.capacity(), shifts.capacity())
                                    : pairs.capacity();
  }

  void resize(std::size_t size) {
    pairs.resize(size);
    shifts.resize(size);
  }
};

/// The list, with what lies in chunks joined to it, has all pairs in the order of their units.
void expect_joined(lists::FoundPairs& found, UsedList& list, lists::ListBuffer& buffer,
                   const PairVector& expected, Shifts stored) {
  base::MemoryMeter memory;
  buffer.hand_over();
  list.resize(expected.size());
  lists::OutputBuffer target{list.pairs, {}};
  if (stored == Shifts::stored) target.shifts = list.shifts;
  lists::PairOrder(memory).join(found.pieces(), target, 2, nobody.work);
  EXPECT_TRUE(std::equal(list.pairs.begin(), list.pairs.end(), expected.begin(), expected.end()));
  for (std::size_t k = 0; k < target.shifts.size(); ++k) {
    ASSERT_EQ(target.shifts[k], shift_of(expected[k])) << k;
  }
}

/// Has one worker find the pairs of all units and joins what it left in chunks to the list, which
/// may grow. Returns how many stood in the list before.
std::size_t put_in_list(const Units& units, UsedList list, Shifts stored, bool may_grow) {
  base::MemoryMeter memory;
  base::ProgressReporter progress;
  lists::FoundPairs found(memory);
  lists::ListBuffer buffer(list.pairs, list.shifts, stored, memory);
  found.start_anew({.shifts = stored, .list = &buffer}, may_grow ? &progress : &nobody.progress);
  units.deliver_in_order(found, progress);
  const std::size_t in_list = found.kept_in_list();
  expect_joined(found, list, buffer, units.together(), stored);
  return in_list;
}

TEST(FoundPairs, OfOneWorkerStandInTheListAsFarAsItHasRoom) {
  const Units units(1);
  const std::size_t all = units.together().size();
  for (const std::size_t room :
       {std::size_t{0}, std::size_t{511}, std::size_t{5000}, all - 100, all, all + 1000}) {
    SCOPED_TRACE(::testing::Message() << "room for " << room);
    const auto expect_filled = [&](std::size_t in_list, std::size_t of) {
      EXPECT_LE(in_list, std::min(of, all));
      EXPECT_GE(in_list + base::PairSink::smallest_buffer, std::min(of, all));
    };
    expect_filled(put_in_list(units, {room, 0}, Shifts::none, false), room);
    for (const std::size_t room_for_shifts : {std::size_t{0}, std::size_t{5000}, all}) {
      SCOPED_TRACE(::testing::Message() << "and for " << room_for_shifts << " shifts");
      expect_filled(put_in_list(units, {room, room_for_shifts}, Shifts::stored, false),
                    std::min(room, room_for_shifts));
    }
  }
}

TEST(FoundPairs, OfOneWorkerStandInAListThatGrows) {
  const Units units(1, 300);
  const std::size_t all = units.together().size();
  for (const std::size_t room : {std::size_t{0}, std::size_t{511}, std::size_t{5000}, all}) {
    for (const std::size_t room_for_shifts : {std::size_t{0}, room}) {
      SCOPED_TRACE(::testing::Message() << "room for " << room << " and " << room_for_shifts);
      EXPECT_GT(put_in_list(units, {room, 0}, Shifts::none, true), all / 2);
      EXPECT_GT(put_in_list(units, {room, room_for_shifts}, Shifts::stored, true), all / 2);
    }
  }
  EXPECT_EQ(put_in_list(units, {0, 0}, Shifts::none, true), all);
}

TEST(FoundPairs, ThatMustBeSortedStandInNoList) {
  const Units units(1);
  UsedList list(units.together().size(), 0);
  base::MemoryMeter memory;
  base::ProgressReporter progress;
  lists::FoundPairs found(memory);
  for (const bool come_sorted : {false, true}) {
    lists::ListBuffer buffer(list.pairs, list.shifts, Shifts::none, memory);
    found.start_anew({.order = Order::canonical, .list = &buffer}, &progress);
    if (come_sorted) found.expect_canonical_order();
    units.deliver_in_order(found, progress);
    EXPECT_EQ(found.kept_in_list() > 0, come_sorted);
    expect_joined(found, list, buffer, units.together(), Shifts::none);
  }
}

/// Few come first, so that the list grows time and again; or most, and the list has room for more.
TEST(FoundPairs, MayBeMoreOrFewerThanExpected) {
  for (const bool most_come_first : {false, true}) {
    Units units(1);
    std::sort(units.pairs.begin(), units.pairs.end(),
              [](const PairVector& a, const PairVector& b) { return a.size() < b.size(); });
    if (most_come_first) std::reverse(units.pairs.begin(), units.pairs.end());
    for (const Shifts stored : {Shifts::none, Shifts::stored}) {
      EXPECT_LE(put_in_list(units, {0, 0}, stored, true), units.together().size());
    }
  }
}

/// Beside the chunks of the first sixteenth, a list that grows holds no pair twice.
TEST(FoundPairs, InAListThatGrowsAreCountedOnce) {
  const Units units(1, 300);
  const std::uint64_t bytes = units.together().size() * sizeof(ContactPair);
  for (const bool grows : {false, true}) {
    UsedList list(0, 0);
    base::MemoryMeter memory;
    base::ProgressReporter progress;
    lists::FoundPairs found(memory);
    {
      lists::ListBuffer buffer(list.pairs, list.shifts, Shifts::none, memory);
      found.start_anew({.list = &buffer}, grows ? &progress : &nobody.progress);
      units.deliver_in_order(found, progress);
      EXPECT_EQ(buffer.used() >= found.size(), grows);
      EXPECT_GE(memory.held(), bytes);
      EXPECT_LE(memory.held(), 2 * bytes);
    }
    EXPECT_EQ(memory.held() < bytes / 2, grows);
  }
}

TEST(ListBuffer, CannotGrowBeyondWhatThereIs) {
  base::MemoryMeter memory;
  UsedList list(10, 0);
  lists::ListBuffer buffer(list.pairs, list.shifts, Shifts::none, memory);
  buffer.room().pairs[0] = {1, 2};
  EXPECT_FALSE(buffer.grow(std::numeric_limits<std::size_t>::max() / 4, 1, nobody.work));
  EXPECT_EQ(buffer.room().pairs.size(), 10U);
  EXPECT_TRUE(buffer.grow(20, 1, nobody.work));
  EXPECT_EQ(buffer.room().pairs[0], (ContactPair{1, 2}));
}

/// Workers that tell of their units write to the list what has its place there; the others do not.
TEST(FoundPairs, OfSeveralWorkersStandInTheListWhereUnitsAreTold) {
  const Units units(1);
  const PairVector expected = units.together();
  for (const std::size_t room : {std::size_t{0}, std::size_t{5000}, expected.size() / 2,
                                 expected.size(), 2 * expected.size()}) {
    for (const Shifts stored : {Shifts::none, Shifts::stored}) {
      for (const std::size_t workers : {2U, 5U, 70U}) {
        SCOPED_TRACE(::testing::Message() << "room for " << room << ", " << workers << " workers");
        UsedList list(room, room);
        base::MemoryMeter memory;
        base::ProgressReporter progress;
        lists::FoundPairs found(memory);
        lists::ListBuffer buffer(list.pairs, list.shifts, stored, memory);
        for (std::uint64_t seed = 1; seed < 4; ++seed) {
          found.start_anew({.shifts = stored, .list = &buffer}, &progress);
          units.deliver_in_turns(found, workers, seed, progress);
          const std::size_t in_list = found.kept_in_list();
          if (room == 2 * expected.size() || (workers == 2 && room != 5000)) {
            EXPECT_GT(in_list, expected.size() / 3);
          }
        }
        expect_joined(found, list, buffer, expected, stored);
      }
    }
  }
  base::MemoryMeter memory;
  lists::FoundPairs found(memory);
  UsedList list(expected.size(), 0);
  lists::ListBuffer buffer(list.pairs, list.shifts, Shifts::none, memory);
  found.start_anew({.list = &buffer}, &nobody.progress);
  units.deliver(found, 2, 3);
  EXPECT_EQ(found.kept_in_list(), 0U);
  EXPECT_EQ(joined(found, 2), expected);
}

/// Some units come before those that are told, and some after.
TEST(FoundPairs, OfUnitsThatAreNotToldKeepTheirPlaces) {
  const Units units(1);
  const Units others(2);
  PairVector expected = others.pairs[0];
  for (const PairVector& unit : units.pairs) {
    expected.insert(expected.end(), unit.begin(), unit.end());
  }
  expected.insert(expected.end(), others.pairs[1].begin(), others.pairs[1].end());
  UsedList list(expected.size(), 0);
  base::MemoryMeter memory;
  lists::FoundPairs found(memory);
  lists::ListBuffer buffer(list.pairs, list.shifts, Shifts::none, memory);
  found.start_anew({.list = &buffer}, &nobody.progress);
  found.expect_workers(2);
  Random random(3);
  const auto deliver = [&](const Units& from, std::size_t unit, std::uint64_t as) {
    const std::size_t worker = random.below(2);
    found.begin_unit({worker, as});
    for (std::size_t done = 0; done < from.pairs[unit].size();) {
      const auto room = found.buffer(worker);
      const std::size_t count = std::min(room.size(), from.pairs[unit].size() - done);
      std::copy_n(from.pairs[unit].begin() + static_cast<std::ptrdiff_t>(done), count,
                  room.begin());
      found.commit(count, {worker, as});
      done += count;
    }
    found.finish_unit({worker, as});
  };
  deliver(others, 0, 0);
  found.expect_units(1, units.pairs.size());
  for (std::size_t unit = 0; unit < units.pairs.size(); ++unit) deliver(units, unit, 1 + unit);
  deliver(others, 1, 1 + units.pairs.size());
  expect_joined(found, list, buffer, expected, Shifts::none);
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

}  // namespace
}  // namespace abut::testing
