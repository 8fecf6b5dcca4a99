// What is shown of long work, and when: by a clock that the test sets.

#include "progress_display.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace abut::cli::testing {
namespace {

using Clock = ProgressDisplay::Clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Clock::time_point start{};

/// What is written to standard error where the display is shown this at that time.
std::string shown(ProgressDisplay& display, const Progress& progress, Clock::duration time) {
  ::testing::internal::CaptureStderr();
  display.show(progress, start + time);
  return ::testing::internal::GetCapturedStderr();
}

TEST(ProgressDisplay, DrawsABarFromHalfASecondOn) {
  ProgressDisplay display(ProgressMode::bar, start);
  EXPECT_EQ(shown(display, {"search", 0, 100}, milliseconds(0)), "");
  EXPECT_EQ(shown(display, {"search", 10, 100}, milliseconds(499)), "");
  EXPECT_EQ(shown(display, {"search", 25, 100}, milliseconds(1000)),
            "\rsearch  25 % [#######-----------------------] 0:03 left");
  EXPECT_EQ(shown(display, {"search", 50, 100}, milliseconds(1099)), "");
  EXPECT_EQ(shown(display, {"search", 200, 100}, milliseconds(1100)),
            "\rsearch 100 % [##############################] 0:00 left");
}

/// The time that is left is that of the phase, which began when it was first shown.
TEST(ProgressDisplay, EachPhaseHasItsOwnTime) {
  ProgressDisplay display(ProgressMode::bar, start);
  EXPECT_NE(shown(display, {"read", 1, 2}, seconds(60)), "");
  EXPECT_EQ(shown(display, {"order", 0, 10}, seconds(70)).substr(0, 13), "\rorder   1:10");
  EXPECT_EQ(shown(display, {"order", 1, 10}, seconds(80)),
            "\rorder   10 % [###---------------------------] 1:30 left");
}

TEST(ProgressDisplay, LogsALineEveryTenSeconds) {
  ProgressDisplay display(ProgressMode::log, start);
  EXPECT_EQ(shown(display, {"read", 0, 0}, milliseconds(9999)), "");
  EXPECT_EQ(shown(display, {"read", 0, 0}, seconds(10)), "abut: read after 0:10\n");
  EXPECT_EQ(shown(display, {"gather", 1, 8}, milliseconds(19999)), "");
  EXPECT_EQ(shown(display, {"gather", 3, 8}, seconds(75)), "abut: search 38 % after 1:15\n");
}

}  // namespace
}  // namespace abut::cli::testing
