// Figures 3.21 to 3.27: eight elements sorted by cell, and the search for cell (5, 7).

#include "book/book_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace abut::testing {
namespace {

trace::CellSystem figure_3_21() {
  return book_system({{4, 7}, {5, 8}, {4, 6}, {5, 7}, {4, 5}, {5, 6}, {3, 7}, {6, 6}});
}

TEST(Figure_3_21_SortingArray, BeforeSorting) {
  const auto recorded = record(Algorithm::sorting_array, figure_3_21());
  const ShownStage& before = recorded.stage_called("step 1");
  EXPECT_EQ(in_book_numbers(before.array("X")), (Numbers{4, 5, 4, 5, 4, 5, 3, 6}));
  EXPECT_EQ(in_book_numbers(before.array("Y")), (Numbers{7, 8, 6, 7, 5, 6, 7, 6}));
  EXPECT_EQ(in_book_numbers(before.array("D")), (Numbers{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Figure_3_21_SortingArray, AfterSorting) {
  const auto recorded = record(Algorithm::sorting_array, figure_3_21());
  const ShownStage& sorted = recorded.stage_called("step 2");
  EXPECT_EQ(in_book_numbers(sorted.array("X")), (Numbers{3, 4, 4, 4, 5, 5, 5, 6}));
  EXPECT_EQ(in_book_numbers(sorted.array("Y")), (Numbers{7, 5, 6, 7, 6, 7, 8, 6}));
  EXPECT_EQ(in_book_numbers(sorted.array("D")), (Numbers{7, 5, 3, 1, 6, 4, 2, 8}));
}

TEST(Figure_3_21_SortingArray, TheSearchForCell57EndsAtElement4InThreeSteps) {
  const auto recorded = record(Algorithm::sorting_array, figure_3_21());
  const Numbers D = in_book_numbers(recorded.stage_called("step 2").array("D"));
  int searches = 0;
  for (const ShownStage* search : recorded.stages_called("binary search")) {
    if (search->cell[0] + 1 != 5 || search->cell[1] + 1 != 7) continue;
    ++searches;
    // Positions in the book's numbers: {1-4 | 5-8} keep right, {5-6 | 7-8} keep left, then 6.
    ASSERT_EQ(search->search_steps.size(), 3u);
    const std::size_t first_step[] = {1, 5, 8, 5, 8};
    const std::size_t second_step[] = {5, 7, 8, 5, 6};
    const std::size_t third_step[] = {5, 6, 6, 6, 6};
    const std::size_t* expected[] = {first_step, second_step, third_step};
    for (std::size_t k = 0; k < 3; ++k) {
      const trace::SearchStep& step = search->search_steps[k];
      EXPECT_EQ(step.first + 1, expected[k][0]) << "step " << k + 1;
      EXPECT_EQ(step.middle + 1, expected[k][1]) << "step " << k + 1;
      EXPECT_EQ(step.last, expected[k][2]) << "step " << k + 1;
      EXPECT_EQ(step.kept_first + 1, expected[k][3]) << "step " << k + 1;
      EXPECT_EQ(step.kept_last, expected[k][4]) << "step " << k + 1;
    }
    EXPECT_EQ(D.at(search->search_steps.back().kept_first), 4);
  }
  // Of the cells whose mask holds (5, 7) only (5, 8) is occupied, by element 2; nothing lies in
  // (4, 8), (6, 8) and (6, 7).
  EXPECT_EQ(searches, 1);
}

TEST(Figure_3_21_SortingArray, CandidatePairs) {
  const std::vector<BookPair> expected{{1, 2}, {1, 3}, {1, 4}, {1, 6}, {1, 7}, {2, 4}, {3, 4},
                                       {3, 5}, {3, 6}, {3, 7}, {4, 6}, {4, 8}, {5, 6}, {6, 8}};
  ASSERT_EQ(expected.size(), 14u);
  for (const Algorithm algorithm : {Algorithm::screening_array, Algorithm::binary_tree,
                                    Algorithm::sorting_array, Algorithm::munjiza_nbs}) {
    EXPECT_EQ(in_book_numbers(record(algorithm, figure_3_21())), expected) << name_of(algorithm);
  }
}

}  // namespace
}  // namespace abut::testing
