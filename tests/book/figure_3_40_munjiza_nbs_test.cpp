// Figures 3.40 to 3.44: ten elements, row by row. Element 9 lies in row 6; the book does not say
// in which column: its dot is left of element 3, hence column 3, or 4. Both are tested.

#include "book/book_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

constexpr std::int32_t none = -1;

RecordedTrace figure_3_40(std::int32_t column_of_9) {
  return record(Algorithm::munjiza_nbs, book_system({{4, 7},
                                                     {5, 8},
                                                     {4, 6},
                                                     {5, 7},
                                                     {4, 5},
                                                     {5, 6},
                                                     {3, 7},
                                                     {6, 6},
                                                     {column_of_9, 6},
                                                     {4, 7}}));
}

const ShownStage& central_row(const RecordedTrace& recorded, std::int32_t row) {
  for (const ShownStage* shown : recorded.stages_called("central row")) {
    if (shown->cell[1] + 1 == row) return *shown;
  }
  throw std::out_of_range("no such central row");
}

Numbers values(const RecordedTrace& recorded, std::int32_t row, std::string_view symbol) {
  return in_book_numbers(central_row(recorded, row).array(symbol));
}

/// Columns of the central cells of a row, in the order met.
Numbers cells_of_row(const RecordedTrace& recorded, std::int32_t row) {
  Numbers columns;
  for (const ShownStage* shown : recorded.stages_called("central cell")) {
    if (shown->cell[1] + 1 == row) columns.push_back(shown->cell[0] + 1);
  }
  return columns;
}

class Figure_3_40_MunjizaNbs : public ::testing::TestWithParam<std::int32_t> {
 protected:
  RecordedTrace recorded = figure_3_40(GetParam());
  bool in_column_3 = GetParam() == 3;
};

TEST_P(Figure_3_40_MunjizaNbs, Stage1PutsEveryElementOnTheListOfItsRow) {
  const ShownStage& stage = recorded.stage_called("stage 1");
  const Numbers B = in_book_numbers(stage.array("B"));
  const Numbers Y = in_book_numbers(stage.array("Y"));
  EXPECT_EQ(B, (Numbers{none, none, none, none, 5, 9, 10, 2, none, none}));
  EXPECT_EQ(Y, (Numbers{none, none, none, 1, none, 3, 4, 6, 8, 7}));
  EXPECT_EQ(book_list(B[5 - 1], Y), (Numbers{5}));
  EXPECT_EQ(book_list(B[6 - 1], Y), (Numbers{9, 8, 6, 3}));
  EXPECT_EQ(book_list(B[7 - 1], Y), (Numbers{10, 7, 4, 1}));
  EXPECT_EQ(book_list(B[8 - 1], Y), (Numbers{2}));
}

TEST_P(Figure_3_40_MunjizaNbs, CentralRowsAreMetInTheOrder7865) {
  EXPECT_EQ(order_met(recorded, "central row", 1), (Numbers{7, 8, 6, 5}));
}

TEST_P(Figure_3_40_MunjizaNbs, CentralRow7) {
  EXPECT_EQ(values(recorded, 7, "A[0]"),
            (Numbers{none, none, 7, 1, 4, none, none, none, none, none}));
  EXPECT_EQ(values(recorded, 7, "A[1]"),
            (Numbers{none, none, in_column_3 ? 9 : none, 3, 6, 8, none, none, none, none}));
  const Numbers X = values(recorded, 7, "X");
  EXPECT_EQ(X[1 - 1], 10);
  for (const std::size_t e : {4u, 7u, 10u}) EXPECT_EQ(X[e - 1], none) << "X[" << e << "]";
  EXPECT_EQ(X[3 - 1], in_column_3 ? none : 9);
  for (const std::size_t e : {6u, 8u, 9u}) EXPECT_EQ(X[e - 1], none) << "X[" << e << "]";
  EXPECT_EQ(cells_of_row(recorded, 7), (Numbers{4, 3, 5}));
}

TEST_P(Figure_3_40_MunjizaNbs, CentralRow8) {
  EXPECT_EQ(values(recorded, 8, "A[0]"),
            (Numbers{none, none, none, none, 2, none, none, none, none, none}));
  EXPECT_EQ(values(recorded, 8, "A[1]"),
            (Numbers{none, none, 7, 1, 4, none, none, none, none, none}));
  EXPECT_EQ(values(recorded, 8, "X")[1 - 1], 10);
  EXPECT_EQ(cells_of_row(recorded, 8), (Numbers{5}));
}

TEST_P(Figure_3_40_MunjizaNbs, CentralRow6) {
  EXPECT_EQ(values(recorded, 6, "A[0]"),
            (Numbers{none, none, in_column_3 ? 9 : none, 3, 6, 8, none, none, none, none}));
  EXPECT_EQ(values(recorded, 6, "A[1]"),
            (Numbers{none, none, none, 5, none, none, none, none, none, none}));
  EXPECT_EQ(values(recorded, 6, "X")[3 - 1], in_column_3 ? none : 9);
  EXPECT_EQ(cells_of_row(recorded, 6), in_column_3 ? (Numbers{3, 6, 5, 4}) : (Numbers{4, 6, 5}));
}

TEST_P(Figure_3_40_MunjizaNbs, CentralRow5) {
  EXPECT_EQ(values(recorded, 5, "A[0]"),
            (Numbers{none, none, none, 5, none, none, none, none, none, none}));
  EXPECT_EQ(values(recorded, 5, "A[1]"), Numbers(10, none));
  EXPECT_EQ(cells_of_row(recorded, 5), (Numbers{4}));
}

TEST_P(Figure_3_40_MunjizaNbs, RowHeadsAreEmptyAtTheEnd) {
  EXPECT_EQ(recorded.last_array().symbol, "B");
  EXPECT_EQ(recorded.last_array().values, Numbers(10, none));
}

TEST_P(Figure_3_40_MunjizaNbs, CandidatePairs) {
  std::vector<BookPair> expected{{1, 2},  {1, 3},  {1, 4},  {1, 6},  {1, 7}, {1, 9}, {1, 10},
                                 {2, 4},  {2, 10}, {3, 4},  {3, 5},  {3, 6}, {3, 7}, {3, 9},
                                 {3, 10}, {4, 6},  {4, 8},  {4, 10}, {5, 6}, {5, 9}, {6, 8},
                                 {6, 10}, {7, 9},  {7, 10}, {9, 10}};
  ASSERT_EQ(expected.size(), 25u);
  if (!in_column_3) {
    expected.insert(expected.end(), {{4, 9}, {6, 9}});
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(expected.size(), 27u);
  }
  EXPECT_EQ(in_book_numbers(recorded), expected);
}

INSTANTIATE_TEST_SUITE_P(ColumnOfElement9, Figure_3_40_MunjizaNbs, ::testing::Values(3, 4));

}  // namespace
}  // namespace abut::testing
