// The hook is called in every phase, may cancel in any, and what it or a visitor throws passes
// through.

#include "support/algorithm_list.hpp"
#include "support/error_expectations.hpp"
#include "support/same_pairs.hpp"
#include "support/scene_view.hpp"

#include <abut/detect.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

namespace abut::testing {
namespace {

using scenes::Scene;

const Scene& scene() {
  static const Scene made = scenes::scene_named("dense").make(9000, 1);
  return made;
}

Options with_hook(Algorithm algorithm, ProgressHook hook) {
  Options options;
  options.algorithm = algorithm;
  options.threads = 1;
  options.progress = std::move(hook);
  return options;
}

TEST(Progress, TellsPhasesAndNeverMoreThanAll) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    std::map<std::string, int> calls;
    std::uint64_t last = 0;
    const auto hook = [&](const Progress& progress) {
      const bool first_of_phase = calls[std::string(progress.phase)]++ == 0;
      EXPECT_LE(progress.done, progress.total);
      if (!first_of_phase) {
        EXPECT_GE(progress.done, last);
      }
      last = progress.done;
      return ProgressAction::proceed;
    };
    static_cast<void>(
        find_contact_pairs(view_of(scene()), Domain::open(), with_hook(algorithm, hook)));
    EXPECT_EQ(calls.size(), 3U);
    EXPECT_GT(calls["gather"], 1);
    EXPECT_GT(calls["search"], 1);
    EXPECT_GT(calls["order"], 0);
  }
}

TEST(Progress, CancelsInEveryPhase) {
  const PairList expected = find_contact_pairs(view_of(scene()));
  for (const Algorithm algorithm : algorithms_for(3)) {
    for (const std::string phase : {"gather", "search", "order"}) {
      SCOPED_TRACE(std::string(name_of(algorithm)) + ", " + phase);
      const auto hook = [&phase](const Progress& progress) {
        return progress.phase == phase ? ProgressAction::cancel : ProgressAction::proceed;
      };
      expect_error(ErrorCode::cancelled, {"cancelled", phase, "elements"}, [&] {
        static_cast<void>(
            find_contact_pairs(view_of(scene()), Domain::open(), with_hook(algorithm, hook)));
      });
    }
    const auto again =
        find_contact_pairs(view_of(scene()), Domain::open(), with_hook(algorithm, {}));
    EXPECT_TRUE(same_canonical_pairs(expected.pairs(), again.pairs()));
  }
}

/// Within a phase too, and no further call follows.
TEST(Progress, CancelsLate) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    int calls = 0;
    const auto hook = [&calls](const Progress& progress) {
      ++calls;
      return progress.phase == "search" && progress.done > 0 ? ProgressAction::cancel
                                                             : ProgressAction::proceed;
    };
    PairCount visited = 0;
    expect_error(ErrorCode::cancelled, {"search"}, [&] {
      for_each_contact_pair(view_of(scene()), Domain::open(), with_hook(algorithm, hook),
                            [&visited](ContactPair) { ++visited; });
    });
    const int calls_then = calls;
    EXPECT_GT(calls_then, 2) << name_of(algorithm);
    EXPECT_LT(visited, find_contact_pairs(view_of(scene())).size());
  }
}

/// One crowded cell: all the work lies in few elements, yet the hook is asked.
TEST(Progress, IsAskedInsideLongStretches) {
  const Scene crowd = scenes::scene_named("coincident").make(1500, 1);
  for (const Algorithm algorithm : algorithms_for(3)) {
    int calls = 0;
    const auto hook = [&calls](const Progress& progress) {
      calls += progress.phase == "search" ? 1 : 0;
      return ProgressAction::proceed;
    };
    static_cast<void>(
        count_contact_pairs(view_of(crowd), Domain::open(), with_hook(algorithm, hook)));
    EXPECT_GT(calls, 3) << name_of(algorithm);
  }
}

struct Stop : std::runtime_error {
  Stop() : std::runtime_error("stop") {}
};

TEST(Progress, ExceptionsOfTheHookPassThrough) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    for (const std::string phase : {"gather", "search", "order"}) {
      const auto hook = [&phase](const Progress& progress) -> ProgressAction {
        if (progress.phase == phase) throw Stop();
        return ProgressAction::proceed;
      };
      EXPECT_THROW(static_cast<void>(find_contact_pairs(view_of(scene()), Domain::open(),
                                                        with_hook(algorithm, hook))),
                   Stop)
          << name_of(algorithm) << ", " << phase;
    }
  }
}

TEST(Visitor, ExceptionsStopTheDetectionAndPassThrough) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    int visited = 0;
    const auto visit = [&visited](ContactPair) {
      if (++visited == 5) throw Stop();
    };
    EXPECT_THROW(
        for_each_contact_pair(view_of(scene()), Domain::open(), with_hook(algorithm, {}), visit),
        Stop)
        << name_of(algorithm);
    EXPECT_EQ(visited, 5);
  }
}

/// Also the kind that abut itself turns into an Error when its own memory runs out.
TEST(Visitor, ItsOwnLackOfMemoryIsNotAbuts) {
  const auto visit = [](ContactPair) { throw std::bad_alloc(); };
  EXPECT_THROW(for_each_contact_pair(view_of(scene()), Domain::open(), {}, visit), std::bad_alloc);
  const auto hook = [](const Progress&) -> ProgressAction { throw std::bad_alloc(); };
  EXPECT_THROW(static_cast<void>(count_contact_pairs(view_of(scene()), Domain::open(),
                                                     with_hook(Algorithm::automatic, hook))),
               std::bad_alloc);
}

TEST(Visitor, MayTakeTheWorkerNumberOrWholeBatches) {
  const PairList expected = find_contact_pairs(view_of(scene()));
  PairVector pairs;
  for_each_contact_pair(view_of(scene()), Domain::open(), {},
                        [&pairs](ContactPair pair, WorkerNumber worker) {
                          EXPECT_EQ(worker, 0);
                          pairs.push_back(pair);
                        });
  EXPECT_TRUE(same_pairs(expected.pairs(), pairs));
  pairs.clear();
  for_each_batch(view_of(scene()), Domain::open(), {},
                 [&pairs](std::span<const ContactPair> batch, WorkerNumber) {
                   EXPECT_FALSE(batch.empty());
                   pairs.insert(pairs.end(), batch.begin(), batch.end());
                 });
  EXPECT_TRUE(same_pairs(expected.pairs(), pairs));
}

/// A detection inside a visitor of another: nothing is shared.
TEST(Visitor, MayDetectItself) {
  const Scene small = scenes::scene_named("dense").make(100, 1);
  const PairCount expected = count_contact_pairs(view_of(small)).contact_pairs;
  PairCount outer = 0;
  for_each_contact_pair(view_of(small), Domain::open(), {}, [&](ContactPair) {
    ++outer;
    EXPECT_EQ(count_contact_pairs(view_of(small)).contact_pairs, expected);
  });
  EXPECT_EQ(outer, expected);
}

}  // namespace
}  // namespace abut::testing
