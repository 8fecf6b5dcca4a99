#include "base/workers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace abut::base {
namespace {

constexpr std::array<std::size_t, 5> counts{1, 2, 3, 7, 16};

TEST(Workers, EachIsCalledOnce) {
  for (const std::size_t count : counts) {
    std::vector<std::atomic<int>> calls(count);
    for_each_worker(count, [&](std::size_t worker) { ++calls.at(worker); });
    for (const auto& number : calls) EXPECT_EQ(number, 1);
  }
}

TEST(Workers, EachIndexIsTakenOnce) {
  for (const std::size_t count : counts) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, count, std::size_t{5000}}) {
      std::vector<std::atomic<int>> calls(size);
      for_each_index(count, size, [&](std::size_t worker, std::size_t k) {
        EXPECT_LT(worker, count);
        ++calls.at(k);
      });
      for (const auto& number : calls) EXPECT_EQ(number, 1);
    }
  }
}

TEST(Workers, TheExceptionOfTheFirstOfThemIsRethrown) {
  for (const std::size_t count : counts) {
    std::atomic<std::size_t> entered = 0;
    try {
      for_each_worker(count, [&](std::size_t worker) {
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

TEST(Workers, AnExceptionStopsTheOthersSoon) {
  constexpr std::size_t size = 1000000;
  for (const std::size_t count : counts) {
    std::atomic<std::size_t> calls = 0;
    // The others dawdle, so that the one that throws has time to say so even if it is interrupted.
    EXPECT_THROW(for_each_index(count, size,
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

/// Rounding to nearest, whatever the caller has set in its own thread.
TEST(Workers, HaveTheFloatingPointEnvironmentOfTheLibrary) {
  std::fesetround(FE_UPWARD);
  std::array<int, 4> modes{};
  for_each_worker(modes.size(), [&](std::size_t worker) { modes.at(worker) = std::fegetround(); });
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
  for (const int mode : modes) EXPECT_EQ(mode, FE_TONEAREST);
}

TEST(WorkerCount, IsWhatWasAskedForOrWhatKeepsBusy) {
  EXPECT_EQ(worker_count(5, 10), 5U);
  EXPECT_EQ(worker_count(0, 0), 1U);
  EXPECT_EQ(worker_count(0, 8191), 1U);
  EXPECT_GE(worker_count(0, std::size_t{1} << 30), 1U);
}

TEST(ShareOf, SharesFollowEachOtherAndAreEqualButForOne) {
  for (const std::size_t count : {1U, 2U, 3U, 7U, 16U, 1000U}) {
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{15},
                                   std::size_t{1000}, std::numeric_limits<std::size_t>::max()}) {
      std::size_t end = 0;
      for (std::size_t worker = 0; worker < count; ++worker) {
        const auto [first, last] = share_of(worker, count, size);
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
}  // namespace abut::base
