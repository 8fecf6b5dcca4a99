// Figures 3.19 and 3.20, eq. 3.31: nine elements in 10 x 10 cells.

#include "book/book_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace abut::testing {
namespace {

trace::CellSystem figure_3_19() {
  return book_system({{5, 7}, {5, 7}, {2, 7}, {5, 7}, {2, 7}, {5, 6}, {2, 7}, {6, 6}, {2, 7}});
}

std::int32_t at(const Numbers& C, std::int32_t i, std::int32_t j) {
  return C.at(static_cast<std::size_t>((i - 1) * 10 + (j - 1)));
}

TEST(Figure_3_20_ScreeningArray, HeadsOfTheCells) {
  const auto recorded = record(Algorithm::screening_array, figure_3_19());
  const ShownArray& shown = recorded.stage_called("step 1").array("C");
  EXPECT_EQ(shown.extent, (std::array<std::int32_t, 3>{10, 10, 1}));
  const Numbers C = in_book_numbers(shown);
  ASSERT_EQ(C.size(), 100u);
  EXPECT_EQ(at(C, 5, 7), 4);
  EXPECT_EQ(at(C, 5, 6), 6);
  EXPECT_EQ(at(C, 6, 6), 8);
  EXPECT_EQ(at(C, 2, 7), 9);
  EXPECT_EQ(std::count(C.begin(), C.end(), -1), 96);
}

TEST(Figure_3_20_ScreeningArray, ListsOfTheElements) {
  const auto recorded = record(Algorithm::screening_array, figure_3_19());
  const Numbers E = in_book_numbers(recorded.stage_called("step 1").array("E"));
  EXPECT_EQ(E, (Numbers{-1, 1, -1, 2, 3, -1, 5, -1, 7}));
  EXPECT_EQ(book_list(4, E), (Numbers{4, 2, 1}));
  EXPECT_EQ(book_list(6, E), (Numbers{6}));
  EXPECT_EQ(book_list(8, E), (Numbers{8}));
  EXPECT_EQ(book_list(9, E), (Numbers{9, 7, 5, 3}));
}

TEST(Figure_3_20_ScreeningArray, EverythingIsEmptyAfterStep3) {
  const auto recorded = record(Algorithm::screening_array, figure_3_19());
  const ShownStage& emptied = recorded.stage_called("step 3");
  EXPECT_EQ(in_book_numbers(emptied.array("C")), Numbers(100, -1));
  EXPECT_EQ(in_book_numbers(emptied.array("E")), Numbers(9, -1));
}

TEST(Figure_3_20_ScreeningArray, CandidatePairs) {
  const std::vector<BookPair> expected{{1, 2}, {1, 4}, {1, 6}, {1, 8}, {2, 4}, {2, 6},
                                       {2, 8}, {3, 5}, {3, 7}, {3, 9}, {4, 6}, {4, 8},
                                       {5, 7}, {5, 9}, {6, 8}, {7, 9}};
  ASSERT_EQ(expected.size(), 16u);
  for (const Algorithm algorithm : {Algorithm::screening_array, Algorithm::binary_tree,
                                    Algorithm::sorting_array, Algorithm::munjiza_nbs}) {
    EXPECT_EQ(in_book_numbers(record(algorithm, figure_3_19())), expected) << name_of(algorithm);
  }
}

}  // namespace
}  // namespace abut::testing
