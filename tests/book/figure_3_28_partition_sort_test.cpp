// Figures 3.28 to 3.38: the first split of sixteen numbers around the middle of their values, 8.

#include "book/book_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>

namespace abut::testing {
namespace {

const Numbers figure_3_28{3, 16, 7, 11, 2, 14, 5, 9, 4, 8, 12, 6, 13, 15, 1, 10};

TEST(Figure_3_28_PartitionSort, TheFirstSplit) {
  const trace::Partition split = trace::first_partition(figure_3_28);
  EXPECT_EQ(split.values, (Numbers{3, 1, 7, 6, 2, 4, 5, 9, 14, 8, 12, 11, 13, 15, 16, 10}));
  EXPECT_EQ(split.left_size, 7u);
}

TEST(Figure_3_28_PartitionSort, TheSplitIsThreeExchanges) {
  // The last one, 14 with 4, is missing in Figures 3.37 and 3.38.
  Numbers exchanged = figure_3_28;
  for (const auto& [a, b] : {BookPair{16, 1}, BookPair{11, 6}, BookPair{14, 4}}) {
    std::iter_swap(std::find(exchanged.begin(), exchanged.end(), a),
                   std::find(exchanged.begin(), exchanged.end(), b));
  }
  EXPECT_EQ(trace::first_partition(figure_3_28).values, exchanged);
}

TEST(Figure_3_28_PartitionSort, BothPartsLieOnTheirSideOfEight) {
  const trace::Partition split = trace::first_partition(figure_3_28);
  for (std::size_t k = 0; k < split.values.size(); ++k) {
    EXPECT_EQ(split.values[k] < 8, k < split.left_size) << "position " << k;
  }
}

TEST(Figure_3_28_PartitionSort, NothingToSplit) {
  EXPECT_TRUE(trace::first_partition({}).values.empty());
  const Numbers equal{5, 5, 5};
  EXPECT_EQ(trace::first_partition(equal).values, equal);
  EXPECT_EQ(trace::first_partition(equal).left_size, 3u);
}

}  // namespace
}  // namespace abut::testing
