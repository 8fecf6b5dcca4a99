#include "base/shortest_text.hpp"

#include "exact/hard_pairs.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

namespace abut::testing {
namespace {

using base::count_text;
using base::shortest_text;

TEST(Written, TheShortestTextThatReadsBack) {
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(shortest_text(-3.0), "-3");
  EXPECT_EQ(shortest_text(-0.0), "-0");
  EXPECT_EQ(shortest_text(1e300), "1e+300");
  EXPECT_EQ(shortest_text(std::numeric_limits<double>::denorm_min()), "5e-324");
  Random random(61);
  for (int k = 0; k < 10000; ++k) {
    const double value = extreme_number(random);
    const std::string text = shortest_text(value);
    double again = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), again).ptr;
    ASSERT_EQ(end, text.data() + text.size()) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(again), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(Written, WhatIsNoNumber) {
  EXPECT_EQ(shortest_text(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(shortest_text(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(shortest_text(HUGE_VAL), "inf");
  EXPECT_EQ(shortest_text(-HUGE_VAL), "-inf");
}

TEST(WrittenCount, DigitsWhileTheyFit) {
  EXPECT_EQ(count_text(0.0), "0");
  EXPECT_EQ(count_text(4294967296.0), "4294967296");
  EXPECT_EQ(count_text(0x1.fffffffffffffp62), "9223372036854774784");
  EXPECT_EQ(count_text(0x1p63), "more than 9e18");
  EXPECT_EQ(count_text(HUGE_VAL), "more than 9e18");
  EXPECT_EQ(count_text(std::numeric_limits<double>::quiet_NaN()), "more than 9e18");
}

}  // namespace
}  // namespace abut::testing
