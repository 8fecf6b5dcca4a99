// Several workers: errors, limits, hooks and visitors; and a process that was forked.

#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detector.hpp>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

namespace abut::testing {
namespace {

using scenes::Scene;

constexpr std::array<int, 4> thread_counts{1, 2, 4, 16};

/// Many tiles.
const Scene& scene() {
  static const Scene made = scenes::scene_named("gas").make(60000, 1);
  return made;
}

PairCount all_pairs() {
  static const PairCount count =
      count_contact_pairs(view_of(scene()), Domain::open(), {.threads = 1}).contact_pairs;
  return count;
}

struct Stop : std::runtime_error {
  Stop() : std::runtime_error("stop") {}
};

TEST(Threads, AsManyAsAskedFor) {
  for (const int threads : thread_counts) {
    const auto statistics =
        count_contact_pairs(view_of(scene()), Domain::open(), {.threads = threads});
    EXPECT_EQ(statistics.threads, threads);
    EXPECT_EQ(statistics.contact_pairs, all_pairs());
  }
  EXPECT_GE(count_contact_pairs(view_of(scene())).threads, 1);
  expect_error(ErrorCode::wrong_usage, {"threads = -1"}, [] {
    static_cast<void>(count_contact_pairs(view_of(scene()), Domain::open(), {.threads = -1}));
  });
}

TEST(Threads, VisitorsSeeEachPairOnceWithTheNumberOfTheirWorker) {
  for (const int threads : thread_counts) {
    std::vector<PairVector> seen(static_cast<std::size_t>(threads));
    for_each_contact_pair(view_of(scene()), Domain::open(), {.threads = threads},
                          [&](ContactPair pair, WorkerNumber worker) {
                            seen.at(static_cast<std::size_t>(worker)).push_back(pair);
                          });
    PairVector together;
    for (const PairVector& pairs : seen)
      together.insert(together.end(), pairs.begin(), pairs.end());
    EXPECT_TRUE(same_pairs(find_contact_pairs(view_of(scene())).pairs(), together)) << threads;
  }
}

TEST(Threads, AWorkersExceptionReachesTheCaller) {
  for (const int threads : thread_counts) {
    for (int k = 0; k < 20; ++k) {
      std::atomic<PairCount> visited = 0;
      const auto visit = [&](ContactPair) {
        if (++visited == 100) throw Stop();
      };
      EXPECT_THROW(
          for_each_contact_pair(view_of(scene()), Domain::open(), {.threads = threads}, visit),
          Stop);
      EXPECT_LT(visited, all_pairs());
    }
  }
}

TEST(Threads, AllWorkersMayThrow) {
  for (const int threads : thread_counts) {
    const auto visit = [](ContactPair) { throw Stop(); };
    EXPECT_THROW(
        for_each_contact_pair(view_of(scene()), Domain::open(), {.threads = threads}, visit), Stop);
  }
}

TEST(Threads, MaxPairsIsKeptAndNoVisitorSeesMore) {
  for (const int threads : thread_counts) {
    Options options{.max_pairs = all_pairs(), .threads = threads};
    EXPECT_EQ(find_contact_pairs(view_of(scene()), Domain::open(), options).size(), all_pairs());
    for (const PairCount limit : {PairCount{0}, PairCount{500}, all_pairs() - 1}) {
      options.max_pairs = limit;
      const std::string told = std::to_string(limit);
      expect_error(ErrorCode::limit_exceeded, {told}, [&] {
        static_cast<void>(find_contact_pairs(view_of(scene()), Domain::open(), options));
      });
      std::atomic<PairCount> seen = 0;
      expect_error(ErrorCode::limit_exceeded, {told}, [&] {
        for_each_contact_pair(view_of(scene()), Domain::open(), options,
                              [&](ContactPair) { ++seen; });
      });
      EXPECT_LE(seen, limit);
    }
  }
}

TEST(Threads, CancelStopsAllAndTheHookStaysInItsThread) {
  for (const int threads : thread_counts) {
    for (const std::string phase : {"gather", "search", "order"}) {
      const auto caller = std::this_thread::get_id();
      Options options{.threads = threads};
      options.progress = [&](const Progress& progress) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        EXPECT_LE(progress.done, progress.total);
        return progress.phase == phase ? ProgressAction::cancel : ProgressAction::proceed;
      };
      expect_error(ErrorCode::cancelled, {"cancelled", phase}, [&] {
        static_cast<void>(find_contact_pairs(view_of(scene()), Domain::open(), options));
      });
    }
  }
}

TEST(Threads, SeveralDetectorsAtOnce) {
  std::array<PairCount, 3> found{};
  std::vector<std::thread> callers;
  for (PairCount& count : found) {
    callers.emplace_back([&count] {
      Detector detector({.threads = 2});
      for (int k = 0; k < 5; ++k) count += detector.find_contact_pairs(view_of(scene())).size();
    });
  }
  for (std::thread& caller : callers) caller.join();
  for (const PairCount count : found) EXPECT_EQ(count, 5 * all_pairs());
}

/// Where a visitor detects, the threads are busy: it works alone, with the right answer.
TEST(Threads, AVisitorMayDetect) {
  const Scene inner = scenes::scene_named("gas").make(20000, 2);
  const PairCount expected =
      count_contact_pairs(view_of(inner), Domain::open(), {.threads = 1}).contact_pairs;
  std::atomic<int> batches = 0;
  const auto visit = [&](std::span<const ContactPair>, WorkerNumber) {
    if (++batches > 8) return;
    const Statistics found = count_contact_pairs(view_of(inner), Domain::open(), {.threads = 4});
    EXPECT_EQ(found.contact_pairs, expected);
    EXPECT_EQ(found.threads, 1);
  };
  for_each_batch(view_of(scene()), Domain::open(), {.threads = 4}, visit);
  EXPECT_GT(batches, 1);
}

/// A process may end anywhere, also in the middle of a detection: here in a visitor that the
/// caller's thread calls, or in one of a helper, while those of all others go on. Only one thread
/// may call exit.
void end_in_a_visitor(bool of_caller) {
  ::alarm(60);
  std::atomic<bool> helped = false;
  std::atomic<bool> ends = false;
  for_each_contact_pair(view_of(scene()), Domain::open(), {.threads = 4},
                        [&](ContactPair, WorkerNumber worker) {
                          if (worker != 0) helped = true;
                          while (!helped) ::sched_yield();
                          if ((worker == 0) == of_caller && !ends.exchange(true)) std::exit(3);
                          while (true) ::pause();
                        });
}

void end_after_a_detection() {
  static_cast<void>(count_contact_pairs(view_of(scene()), Domain::open(), {.threads = 4}));
  std::exit(4);
}

TEST(ThreadsDeathTest, AProcessEndsWithHelpersAsleepOrAtWork) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(end_in_a_visitor(true), ::testing::ExitedWithCode(3), "");
  EXPECT_EXIT(end_in_a_visitor(false), ::testing::ExitedWithCode(3), "");
  EXPECT_EXIT(end_after_a_detection(), ::testing::ExitedWithCode(4), "");
}

enum class ChildEnds { at_once, orderly };

/// What a child process does with threads asked for: 0 if that is right, 1 if not; killed by
/// SIGALRM where it hangs.
int outcome_in_child(const PairVector& expected, ChildEnds how) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(60);
    bool right = false;
    try {
      const auto found = find_contact_pairs(view_of(scene()), Domain::open(), {.threads = 4});
      right = same_canonical_pairs(expected, found.pairs()) && found.statistics().threads == 1;
    } catch (...) {
    }
    if (how == ChildEnds::at_once) ::_exit(right ? 0 : 1);
    // With the destructors of the thread's own: they must not wait for threads that are not there.
    std::exit(right ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(Threads, AForkedProcessDetectsWithoutThem) {
  const PairList before = find_contact_pairs(view_of(scene()), Domain::open(), {.threads = 4});
  const PairVector expected(before.begin(), before.end());
  EXPECT_EQ(outcome_in_child(expected, ChildEnds::at_once), 0);
  EXPECT_EQ(outcome_in_child(expected, ChildEnds::orderly), 0);
  const PairList after = find_contact_pairs(view_of(scene()), Domain::open(), {.threads = 4});
  EXPECT_EQ(after.statistics().threads, 4) << "the parent keeps its threads";
  EXPECT_TRUE(same_canonical_pairs(expected, after.pairs()));
}

/// 199,990,000 pairs, 1.6 GB if they were stored.
TEST(Crowd, TwentyThousandCoincidentElementsAreCountedWithoutStoring) {
  const Scene crowd = scenes::scene_named("coincident").make(20000, 1);
  for (const int threads : {1, 2}) {
    const auto statistics =
        count_contact_pairs(view_of(crowd), Domain::open(), {.threads = threads});
    EXPECT_EQ(statistics.contact_pairs, 199990000U);
    EXPECT_LT(statistics.peak_bytes, 200 * crowd.size());
  }
  expect_error(ErrorCode::limit_exceeded, {"bytes"}, [&] {
    static_cast<void>(
        find_contact_pairs(view_of(crowd), Domain::open(), {.max_bytes = std::uint64_t{64} << 20}));
  });
}

}  // namespace
}  // namespace abut::testing
