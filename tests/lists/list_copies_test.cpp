// The hook is asked while found pairs are copied to the list, and while a list is moved.

#include "base/progress_reporter.hpp"
#include "detect/asking_hook.hpp"
#include "lists/found_pairs.hpp"
#include "lists/list_buffer.hpp"
#include "lists/order_pairs.hpp"
#include "support/error_expectations.hpp"
#include "support/nobody_asked.hpp"

#include <abut/error.hpp>
#include <abut/pair_list.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::testing {
namespace {

constexpr std::size_t many = 1'000'000;

/// Steps between two questions; the last of them are told in pieces.
constexpr std::uint64_t steps = 65536 + 8192;

ContactPair pair_number(std::size_t k) {
  return {static_cast<ElementIndex>(k), static_cast<ElementIndex>(k + 1)};
}

/// Two workers: the caller's, whose unit is the second, and another one with the first, which is
/// finished last. What the caller's worker found in the meantime is copied to the list then.
class LateUnit {
 public:
  explicit LateUnit(Shifts stored) : buffer_(pairs_, shifts_, stored, memory_), stored_(stored) {
    static_cast<void>(buffer_.grow(2 * many, 0, nobody_.work));
  }

  /// Finds the pairs of the second unit.
  void find(const ProgressHook& hook) {
    progress_.emplace(hook);
    found_.start_anew({.shifts = stored_, .list = &buffer_}, &*progress_);
    found_.expect_workers(2);
    found_.expect_units(0, 2);
    found_.begin_unit({1, 0});
    found_.begin_unit({0, 1});
    for (std::size_t done = 0; done < many;) {
      const auto room = found_.buffer(0);
      const std::size_t count = std::min(room.size(), many - done);
      for (std::size_t k = 0; k < count; ++k) room[k] = pair_number(done + k);
      const auto shifts = found_.shift_buffer(0);
      std::fill_n(shifts.begin(), std::min(shifts.size(), count), ImageShift{1, 2, 3});
      found_.commit(count, {0, 1});
      done += count;
    }
    ASSERT_EQ(found_.kept_in_list(), 0U);
  }

  /// Finishes both units, the first of which has no pairs.
  void finish() {
    found_.finish_unit({1, 0});
    found_.finish_unit({0, 1});
  }

  void expect_in_list() {
    ASSERT_EQ(found_.kept_in_list(), many);
    for (std::size_t k = 0; k < many; ++k) ASSERT_EQ(buffer_.room().pairs[k], pair_number(k));
    if (stored_ == Shifts::none) return;
    for (std::size_t k = 0; k < many; ++k) {
      ASSERT_EQ(buffer_.room().shifts[k], (ImageShift{1, 2, 3}));
    }
  }

  [[nodiscard]] lists::FoundPairs& found() { return found_; }

 private:
  NobodyAsked nobody_;
  base::MemoryMeter memory_;
  PairArray pairs_;
  ShiftArray shifts_;
  lists::ListBuffer buffer_;
  Shifts stored_;
  std::optional<base::ProgressReporter> progress_;
  lists::FoundPairs found_{memory_};
};

TEST(ListCopies, AreAskedForWhenAUnitGetsItsPlace) {
  for (const Shifts stored : {Shifts::none, Shifts::stored}) {
    LateUnit late(stored);
    Hook asked;
    const ProgressHook hook = asked.hook();
    late.find(hook);
    ASSERT_EQ(asked.all, 0U);
    late.finish();
    EXPECT_GE(asked.all, (stored == Shifts::stored ? 2 : 1) * many / steps);
    late.expect_in_list();
  }
}

TEST(ListCopies, AreAskedForWhenFoundPairsAreJoined) {
  LateUnit late(Shifts::none);
  Hook asked;
  const ProgressHook hook = asked.hook();
  late.find(hook);
  PairArray list(many);
  base::MemoryMeter memory;
  base::ProgressReporter progress(hook);
  base::WorkCounter work(progress, 0);
  lists::PairOrder(memory).join(late.found().pieces(), {list, {}}, 1, work);
  EXPECT_GE(asked.all, many / steps);
  for (std::size_t k = 0; k < many; ++k) ASSERT_EQ(list[k], pair_number(k));
}

TEST(ListCopies, EndWhenTheHookCancels) {
  LateUnit late(Shifts::stored);
  Hook asked;
  asked.cancelled_at = 3;
  const ProgressHook hook = asked.hook();
  late.find(hook);
  expect_error(ErrorCode::cancelled, {"cancelled"}, [&] { late.finish(); });
  EXPECT_EQ(asked.all, 3U);
}

/// While pairs are found, when more come than were expected, and at the end.
TEST(ListCopies, AreAskedForWhenAListIsMoved) {
  for (const bool in_the_end : {false, true}) {
    base::MemoryMeter memory;
    PairArray pairs;
    ShiftArray shifts;
    Hook asked;
    const ProgressHook hook = asked.hook();
    base::ProgressReporter progress(hook);
    base::WorkCounter work(progress, 0);
    lists::ListBuffer buffer(pairs, shifts, Shifts::none, memory);
    ASSERT_TRUE(buffer.grow(many, 0, work));
    for (std::size_t k = 0; k < many; ++k) buffer.room().pairs[k] = pair_number(k);
    ASSERT_EQ(asked.all, 0U);
    if (in_the_end) {
      buffer.hand_over(2 * many, many, work);
    } else {
      ASSERT_TRUE(buffer.grow(2 * many, many, work));
    }
    EXPECT_GE(buffer.room().pairs.size(), 2 * many);
    EXPECT_GE(asked.all, many / steps);
    for (std::size_t k = 0; k < many; ++k) ASSERT_EQ(buffer.room().pairs[k], pair_number(k));
  }
}

}  // namespace
}  // namespace abut::testing
