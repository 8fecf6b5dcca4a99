// Durations as people read them.

#include "text/human_text.hpp"

#include <gtest/gtest.h>

namespace abut::cli::testing {
namespace {

TEST(HumanText, Durations) {
  EXPECT_EQ(duration(0.00031), "0.31 ms");
  EXPECT_EQ(duration(0.01), "10.0 ms");
  EXPECT_EQ(duration(2.125), "2.12 s");
  EXPECT_EQ(duration(99.0), "99.00 s");
  EXPECT_EQ(duration(100.0), "1 min 40 s");
  EXPECT_EQ(duration(199.6), "3 min 20 s");
}

}  // namespace
}  // namespace abut::cli::testing
