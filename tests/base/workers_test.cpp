#include "base/workers.hpp"

#include "support/thread_faults.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cstdint>
#include <latch>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace abut::testing {
namespace {

using testing::Thread;
using testing::ThreadFault;

constexpr std::array<std::size_t, 5> counts{1, 2, 3, 7, 16};

/// Calls of more workers than there are threads, and of fewer.
class Workers : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { ASSERT_GE(base::worker_count(GetParam(), 1000), 1U); }
};

INSTANTIATE_TEST_SUITE_P(Threads, Workers, ::testing::Values(1, 5, 16));

TEST_P(Workers, EachIsCalledOnce) {
  for (const std::size_t count : counts) {
    std::vector<std::atomic<int>> calls(count);
    base::for_each_worker(count, [&](std::size_t worker) { ++calls.at(worker); });
    for (const auto& number : calls) EXPECT_EQ(number, 1);
  }
}

TEST_P(Workers, EachIndexIsTakenOnce) {
  for (const std::size_t count : counts) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, count, std::size_t{5000}}) {
      std::vector<std::atomic<int>> calls(size);
      base::for_each_index(count, size, [&](std::size_t worker, std::size_t k) {
        EXPECT_LT(worker, count);
        ++calls.at(k);
      });
      for (const auto& number : calls) EXPECT_EQ(number, 1);
    }
  }
}

TEST_P(Workers, TheExceptionOfTheFirstOfThemIsRethrown) {
  for (const std::size_t count : counts) {
    std::atomic<std::size_t> entered = 0;
    try {
      base::for_each_worker(count, [&](std::size_t worker) {
        ++entered;
        throw std::runtime_error(std::to_string(worker));
      });
      ADD_FAILURE() << "no exception";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "0");
    }
    EXPECT_EQ(entered, count);
  }
}

TEST_P(Workers, AnExceptionStopsTheOthersSoon) {
  constexpr std::size_t size = 1000000;
  for (const std::size_t count : counts) {
    std::atomic<std::size_t> calls = 0;
    // The others dawdle, so that the one that throws has time to say so even if it is interrupted.
    EXPECT_THROW(base::for_each_index(count, size,
                                      [&](std::size_t, std::size_t) {
                                        const std::size_t call = ++calls;
                                        if (call == 10) throw std::runtime_error("enough");
                                        if (call > 10)
                                          std::this_thread::sleep_for(std::chrono::milliseconds(1));
                                      }),
                 std::runtime_error);
    EXPECT_LT(calls, size);
  }
}

/// 1 + 2^-60: more than 1 only where sums are rounded upwards.
double rounded_sum() {
  const volatile double one = 1.0;
  const volatile double grain = 0x1p-60;
  return one + grain;
}

/// Rounding to nearest, whatever the caller has set in its own thread: also a helper's, which
/// begins with what the thread has that starts it.
TEST(WorkersOfTheLibrary, HaveItsFloatingPointEnvironment) {
  std::array<double, 4> sums{};
  double of_caller = 0.0;
  std::thread([&] {
    std::fesetround(FE_UPWARD);
    ASSERT_EQ(base::worker_count(4, 1000), sums.size());
    std::latch all(4);
    base::for_each_worker(sums.size(), [&](std::size_t worker) {
      all.arrive_and_wait();
      sums.at(worker) = rounded_sum();
    });
    of_caller = rounded_sum();
  }).join();
  EXPECT_GT(of_caller, 1.0);
  for (const double sum : sums) EXPECT_EQ(sum, 1.0);
}

TEST(WorkerCount, IsWhatWasAskedForOrWhatKeepsBusy) {
  EXPECT_EQ(base::worker_count(5, 10), 5U);
  EXPECT_EQ(base::worker_count(2, 10), 2U);
  EXPECT_EQ(base::worker_count(0, 0), 1U);
  EXPECT_EQ(base::worker_count(0, 8191), 1U);
  EXPECT_GE(base::worker_count(0, std::size_t{1} << 30), 1U);
}

TEST(WorkerCount, IsNeverMoreThanElements) {
  EXPECT_EQ(base::worker_count(5, 3), 3U);
  EXPECT_EQ(base::worker_count(5, 1), 1U);
  EXPECT_EQ(base::worker_count(100000, 0), 1U);
  EXPECT_EQ(base::worker_count(std::numeric_limits<int>::max(), 7), 7U);
}

/// In a thread of its own, so that it has no helpers yet.
TEST(WorkerCount, IsOfThoseThatWereNotRefused) {
  for (std::uint64_t refused = 0; refused < 4; ++refused) {
    const ThreadFault fault(refused, Thread::refused);
    std::thread([&] {
      EXPECT_EQ(base::worker_count(4, 1000), refused < 3 ? refused + 1 : 4);
      std::array<std::atomic<int>, 4> calls{};
      base::for_each_worker(4, [&](std::size_t worker) { ++calls.at(worker); });
      for (const auto& number : calls) EXPECT_EQ(number, 1);
    }).join();
  }
}

TEST(WorkerCount, IsOneWithinWorkThatIsBeingDone) {
  ASSERT_EQ(base::worker_count(3, 1000), 3U);
  std::array<std::size_t, 3> inner{};
  std::array<std::atomic<int>, 9> calls{};
  std::latch all(3);
  base::for_each_worker(3, [&](std::size_t worker) {
    all.arrive_and_wait();
    inner.at(worker) = base::worker_count(8, 1000);
    base::for_each_worker(3, [&](std::size_t share) { ++calls.at(3 * worker + share); });
  });
  for (const std::size_t count : inner) EXPECT_EQ(count, 1U);
  for (const auto& number : calls) EXPECT_EQ(number, 1);
}

TEST(ShareOf, SharesFollowEachOtherAndAreEqualButForOne) {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 16U, 1000U}) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{15},
                                   std::size_t{1000}, std::numeric_limits<std::size_t>::max()}) {
      std::size_t end = 0;
      for (std::size_t worker = 0; worker < count; ++worker) {
        const auto [first, last] = base::share_of(worker, count, size);
        ASSERT_EQ(first, end);
        ASSERT_GE(last, first);
        ASSERT_LE(last - first - size / count, 1U);
        end = last;
      }
      EXPECT_EQ(end, size);
    }
  }
}

}  // namespace
}  // namespace abut::testing
