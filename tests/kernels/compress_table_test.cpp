#include "kernels/compress_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>

namespace abut::testing {
namespace {

TEST(CompressTable, WantedLanesInOrderThenTheOthers) {
  for (std::size_t mask = 0; mask < kernels::compress_table.size(); ++mask) {
    const auto& row = kernels::compress_table[mask];
    const int wanted = std::popcount(mask);
    for (int k = 0; k < 8; ++k) {
      EXPECT_EQ((mask >> row[static_cast<std::size_t>(k)] & 1) != 0, k < wanted) << mask;
    }
    EXPECT_TRUE(std::is_sorted(row.begin(), row.begin() + wanted)) << mask;
    EXPECT_TRUE(std::is_sorted(row.begin() + wanted, row.end())) << mask;
  }
}

/// Vectors of four lanes never ask for a lane beyond their own.
TEST(CompressTable, FourLanesStayAmongThemselves) {
  for (std::size_t mask = 0; mask < 16; ++mask) {
    EXPECT_LT(*std::max_element(kernels::compress_table[mask].begin(),
                                kernels::compress_table[mask].begin() + 4),
              4);
  }
}

}  // namespace
}  // namespace abut::testing
