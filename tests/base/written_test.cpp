#include "base/written.hpp"

#include "exact/hard_pairs.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

namespace abut::test {
namespace {

using base::written;
using base::written_count;

TEST(Written, TheShortestTextThatReadsBack) {
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(-3.0), "-3");
  EXPECT_EQ(written(-0.0), "-0");
  EXPECT_EQ(written(1e300), "1e+300");
  EXPECT_EQ(written(std::numeric_limits<double>::denorm_min()), "5e-324");
  Random random(61);
  for (int k = 0; k < 10000; ++k) {
    const double value = extreme_number(random);
    const std::string text = written(value);
    double again = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), again).ptr;
    ASSERT_EQ(end, text.data() + text.size()) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(again), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(Written, WhatIsNoNumber) {
  EXPECT_EQ(written(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(written(-std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(written(HUGE_VAL), "inf");
  EXPECT_EQ(written(-HUGE_VAL), "-inf");
}

TEST(WrittenCount, DigitsWhileTheyFit) {
  EXPECT_EQ(written_count(0.0), "0");
  EXPECT_EQ(written_count(4294967296.0), "4294967296");
  EXPECT_EQ(written_count(0x1.fffffffffffffp62), "9223372036854774784");
  EXPECT_EQ(written_count(0x1p63), "more than 9e18");
  EXPECT_EQ(written_count(HUGE_VAL), "more than 9e18");
  EXPECT_EQ(written_count(std::numeric_limits<double>::quiet_NaN()), "more than 9e18");
}

}  // namespace
}  // namespace abut::test
