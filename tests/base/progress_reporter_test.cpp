#include "base/progress_reporter.hpp"

#include <gtest/gtest.h>
#include <abut/error.hpp>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

struct Seen {
  std::string phase;
  std::uint64_t done;
  std::uint64_t total;
  friend bool operator==(const Seen&, const Seen&) = default;
};

TEST(ProgressReporter, CallsTheHookAtTheBeginAndNowAndThen) {
  std::vector<Seen> seen;
  const ProgressHook hook = [&](const Progress& progress) {
    seen.push_back({std::string(progress.phase), progress.done, progress.total});
    return ProgressAction::proceed;
  };
  base::ProgressReporter reporter(hook);
  reporter.begin("search", 10000);
  for (std::uint64_t k = 1; k <= 10000; ++k) reporter.at(k);
  reporter.poll();
  reporter.begin("order", 7);
  EXPECT_EQ(seen, (std::vector<Seen>{{"search", 0, 10000},
                                     {"search", 4096, 10000},
                                     {"search", 8192, 10000},
                                     {"search", 8192, 10000},
                                     {"order", 0, 7}}));
}

TEST(ProgressReporter, CancelIsAnErrorThatTellsWhere) {
  const ProgressHook hook = [](const Progress& progress) {
    return progress.done < 4096 ? ProgressAction::proceed : ProgressAction::cancel;
  };
  base::ProgressReporter reporter(hook);
  reporter.begin("search", 9000);
  try {
    for (std::uint64_t k = 0; k < 9000; ++k) reporter.at(k);
    FAIL() << "not cancelled";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::cancelled);
    EXPECT_STREQ(error.what(), "cancelled in phase search after 4096 of 9000 elements");
  }
}

TEST(ProgressReporter, WhatTheHookThrowsPassesThrough) {
  const ProgressHook hook = [](const Progress&) -> ProgressAction {
    throw std::domain_error("mine");
  };
  base::ProgressReporter reporter(hook);
  EXPECT_THROW(reporter.begin("gather", 1), std::domain_error);
}

TEST(ProgressReporter, NoHookIsNothingToCall) {
  base::ProgressReporter none;
  EXPECT_NO_THROW(none.begin("search", 1));
  EXPECT_NO_THROW(none.at(0));
  const ProgressHook empty;
  base::ProgressReporter without(empty);
  EXPECT_NO_THROW(without.poll());
}

}  // namespace
}  // namespace abut::testing
