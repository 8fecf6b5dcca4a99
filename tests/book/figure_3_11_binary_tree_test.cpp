// Figures 3.11 to 3.14: elements 3, 5, 7 and 9 on the list of one leaf; then element 1 is added.

#include "book/book_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace abut::testing {
namespace {

/// The leaf of a cell, found by halving the 16 x 16 cells around the 10 x 10 as the book does: x
/// before y, left and lower half first. Returns the value of HEAD.
std::int32_t head_of(const ShownStage& built, std::int32_t i, std::int32_t j) {
  const auto& left = built.array("left node").values;
  const auto& right = built.array("right node").values;
  std::int32_t node = 0;
  std::int32_t low[2] = {1, 1};
  std::int32_t high[2] = {17, 17};
  const std::int32_t cell[2] = {i, j};
  for (std::size_t level = 0; level < 8; ++level) {
    const std::size_t axis = level % 2;
    const std::int32_t middle = (low[axis] + high[axis]) / 2;
    const bool goes_left = cell[axis] < middle;
    (goes_left ? high[axis] : low[axis]) = middle;
    node = (goes_left ? left : right).at(static_cast<std::size_t>(node));
    if (node == -1) return -1;
  }
  return in_book_numbers(built.array("HEAD")).at(static_cast<std::size_t>(node));
}

TEST(Figure_3_11_BinaryTree, FourElementsOfOneCellHangOnOneLeaf) {
  const auto recorded =
      record(Algorithm::binary_tree,
             book_system({{5, 7}, {5, 7}, {2, 7}, {5, 7}, {2, 7}, {5, 6}, {2, 7}, {6, 6}, {2, 7}}));
  const ShownStage& built = recorded.stage_called("build");
  const Numbers E = in_book_numbers(built.array("E"));
  EXPECT_EQ(head_of(built, 2, 7), 9);
  EXPECT_EQ(book_list(9, E), (Numbers{9, 7, 5, 3}));
  EXPECT_EQ(E[5 - 1], 3);
  EXPECT_EQ(E[7 - 1], 5);
  EXPECT_EQ(E[9 - 1], 7);
  EXPECT_EQ(E[3 - 1], -1);
  EXPECT_EQ(head_of(built, 5, 7), 4);
  EXPECT_EQ(head_of(built, 5, 6), 6);
  EXPECT_EQ(head_of(built, 6, 6), 8);
  EXPECT_EQ(head_of(built, 7, 7), -1);
}

TEST(Figure_3_11_BinaryTree, AnAddedElementBecomesTheHead) {
  // The library inserts in ascending number; the book adds element 1 last. So the five elements
  // are numbered here in the book's order of insertion.
  const Numbers book_name{3, 5, 7, 9, 1};
  const auto recorded =
      record(Algorithm::binary_tree, book_system({{2, 7}, {2, 7}, {2, 7}, {2, 7}, {2, 7}}));
  const ShownStage& built = recorded.stage_called("build");
  const auto name = [&](std::int32_t e) {
    return e == -1 ? -1 : book_name.at(static_cast<std::size_t>(e - 1));
  };
  EXPECT_EQ(name(head_of(built, 2, 7)), 1);
  const Numbers E = in_book_numbers(built.array("E"));
  EXPECT_EQ(name(E[4]), 9) << "E[1]";
  EXPECT_EQ(name(E[3]), 7) << "E[9]";
  EXPECT_EQ(name(E[2]), 5) << "E[7]";
  EXPECT_EQ(name(E[1]), 3) << "E[5]";
  EXPECT_EQ(name(E[0]), -1) << "E[3]";
}

}  // namespace
}  // namespace abut::testing
