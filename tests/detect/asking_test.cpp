// How much work passes between two questions to the hook, and who stops after an answer.

#include "detect/asking_hook.hpp"
#include "support/algorithm_list.hpp"
#include "support/error_expectations.hpp"
#include "support/scene_view.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Scene;

/// Steps between two questions, twice: the last of them are told in blocks.
constexpr std::uint64_t steps = 2 * 65536;

Options options_of(Algorithm algorithm, Hook& hook) {
  Options options;
  options.algorithm = algorithm;
  options.threads = 1;
  options.progress = hook.hook();
  return options;
}

/// Thin plates one above the other, in one cell as they are wide: many tests and no pair.
struct Plates {
  explicit Plates(std::size_t count) : x(count, 0.0), far(count, 1.0), bottom(count), top(count) {
    for (std::size_t k = 0; k < count; ++k) {
      bottom[k] = 1e-5 * static_cast<double>(k);
      top[k] = bottom[k] + 1e-6;
    }
  }
  [[nodiscard]] ElementView view() const { return boxes(x, x, bottom, far, far, top); }

  std::vector<double> x, far, bottom, top;
};

TEST(Asking, FollowsTheTestsInOneCell) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    Hook hook;
    const Statistics counted =
        count_contact_pairs(view_of(crowd(3000)), Domain::open(), options_of(algorithm, hook));
    EXPECT_EQ(counted.contact_pairs, 3000U * 2999U / 2U);
    EXPECT_GE(hook.asked["search"], counted.candidate_tests / steps);
  }
}

TEST(Asking, FollowsTestsThatFindNothing) {
  const Plates plates(3000);
  for (const Simd level : {Simd::scalar, Simd::automatic}) {
    Hook hook;
    Options options = options_of(Algorithm::rows, hook);
    options.simd = level;
    const Statistics counted = count_contact_pairs(plates.view(), Domain::open(), options);
    EXPECT_EQ(counted.contact_pairs, 0U);
    EXPECT_GE(counted.candidate_tests, 1'000'000U);
    EXPECT_GE(hook.asked["search"], counted.candidate_tests / steps);
  }
}

/// Between two questions a visitor sees no more pairs than there are steps.
TEST(Asking, NoMorePairsPassThanSteps) {
  for (const Algorithm algorithm : algorithms_for(3)) {
    SCOPED_TRACE(std::string(name_of(algorithm)));
    std::uint64_t passed = 0;
    std::uint64_t most = 0;
    Options options;
    options.algorithm = algorithm;
    options.threads = 1;
    options.progress = [&](const Progress&) {
      most = std::max(most, std::exchange(passed, 0));
      return ProgressAction::proceed;
    };
    for_each_batch(
        view_of(crowd(3000)), Domain::open(), options,
        [&](std::span<const ContactPair> pairs, WorkerNumber) { passed += pairs.size(); });
    EXPECT_GT(most, 0U);
    EXPECT_LE(std::max(most, passed), steps);
  }
}

/// A visitor that waits, now and then, until the hook was asked once more.
class Rendezvous {
 public:
  void ask() {
    const std::lock_guard lock(mutex_);
    ++questions_;
    asked_.notify_all();
  }

  /// False if that takes very long.
  bool wait_for_more_than(std::uint64_t questions) {
    std::unique_lock lock(mutex_);
    return asked_.wait_for(lock, std::chrono::minutes(2), [&] { return questions_ > questions; });
  }

  std::uint64_t questions() {
    const std::lock_guard lock(mutex_);
    return questions_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable asked_;
  std::uint64_t questions_ = 0;
};

/// All the work lies in one place, which any worker may take: the caller's thread, which has none,
/// asks for it.
TEST(Asking, TheCallersThreadAsksForTheOthers) {
  for (const int threads : {2, 5}) {
    Rendezvous rendezvous;
    Options options;
    options.threads = threads;
    options.progress = [&](const Progress&) {
      rendezvous.ask();
      return ProgressAction::proceed;
    };
    std::atomic<std::uint64_t> found = 0;
    std::array<std::uint64_t, 5> passed{};  // of each worker, since it last waited
    std::array<std::uint64_t, 5> seen{};
    for_each_batch(view_of(crowd(3000)), Domain::open(), options,
                   [&](std::span<const ContactPair> pairs, WorkerNumber number) {
                     const auto worker = static_cast<std::size_t>(number);
                     found += pairs.size();
                     passed[worker] += pairs.size();
                     if (worker == 0 || passed[worker] < 4 * steps) return;
                     EXPECT_TRUE(rendezvous.wait_for_more_than(seen[worker]));
                     seen[worker] = rendezvous.questions();
                     passed[worker] = 0;
                   });
    EXPECT_EQ(found, 3000U * 2999U / 2U);
  }
}

/// When the hook cancels, the others stop where they are.
TEST(Asking, ACancelStopsTheOthers) {
  for (const int threads : {2, 5}) {
    std::atomic<bool> is_cancelled = false;
    std::atomic<std::uint64_t> found = 0;
    Options options;
    options.threads = threads;
    options.progress = [&](const Progress&) {
      is_cancelled = found > 0;
      return is_cancelled ? ProgressAction::cancel : ProgressAction::proceed;
    };
    expect_error(ErrorCode::cancelled, {"search"}, [&] {
      for_each_batch(view_of(crowd(3000)), Domain::open(), options,
                     [&](std::span<const ContactPair> pairs, WorkerNumber) {
                       found += pairs.size();
                       // Whoever cancelled has yet to tell the others.
                       if (is_cancelled) std::this_thread::yield();
                     });
    });
    EXPECT_TRUE(is_cancelled);
  }
}

/// An exception of a visitor, too.
TEST(Asking, AVisitorsExceptionStopsTheOthers) {
  struct Enough {};
  std::atomic<std::uint64_t> found = 0;
  Options options;
  options.threads = 2;
  EXPECT_THROW(for_each_batch(view_of(crowd(3000)), Domain::open(), options,
                              [&](std::span<const ContactPair> pairs, WorkerNumber) {
                                if ((found += pairs.size()) > steps) throw Enough();
                              }),
               Enough);
  EXPECT_LT(found, 3000U * 2999U / 2U);
}

TEST(Asking, FollowsTheElementsBeforeTheSearchAndThePairsBehindIt) {
  static const Scene dense = scenes::scene_named("dense").make(200'000, 1);
  for (const Order order : {Order::canonical, Order::as_found}) {
    Hook hook;
    Options options = options_of(Algorithm::rows, hook);
    options.order = order;
    const PairList list = find_contact_pairs(view_of(dense), Domain::open(), options);
    EXPECT_GE(hook.asked["gather"], 8 * dense.size() / steps);
    // Placed and scattered, then sorted in the tiles.
    EXPECT_GE(hook.asked["search"], (4 * dense.size() + list.statistics().candidate_tests) / steps);
    // As they are found, pairs stand in the list already.
    const std::size_t passes = order == Order::canonical ? 4 : 0;
    EXPECT_GE(hook.asked["order"], passes * list.size() / steps);
  }
}

/// In layers, where each has a table of its cells besides: nearly empty ones are sorted more than
/// tested.
TEST(Asking, FollowsTheSortIntoLayers) {
  for (const char* const name : {"sparse", "gas_2d"}) {
    const Scene scene = scenes::scene_named(name).make(400'000, 1);
    Hook hook;
    const Statistics counted =
        count_contact_pairs(view_of(scene), Domain::open(), options_of(Algorithm::rows, hook));
    // Counted and scattered; then counted, placed, and split into columns.
    EXPECT_GE(hook.asked["search"], (5 * scene.size() + counted.candidate_tests) / (65536 + 8192));
  }
}

/// Pairs of few elements, in long rows.
TEST(Asking, FollowsTheOrderOfManyPairsOfEach) {
  for (const Domain& domain : {Domain::open(), Domain::periodic(std::array{1e6, 1e6, 1e6})}) {
    for (const NeighborListKind kind : {NeighborListKind::half, NeighborListKind::full}) {
      Hook hook;
      Options options = options_of(Algorithm::rows, hook);
      options.shifts = Shifts::stored;
      options.quantities = Quantity::distance;
      const NeighborList list = build_neighbor_list(view_of(crowd(1500)), domain, kind, options);
      EXPECT_GE(hook.asked["order"], 18 * list.neighbors().size() / steps);
    }
  }
}

}  // namespace
}  // namespace abut::testing
