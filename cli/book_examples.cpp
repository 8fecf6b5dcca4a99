// The worked examples of A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004,
// chapter 3. Each figure has a system of its own: the cells of one must not be used for another.

#include "book_examples.hpp"

#include "text/array_text.hpp"

#include <abut/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace abut::cli {
namespace {

using Cells = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Cells as printed, from 1.
trace::CellSystem square(std::int32_t cell_count, const Cells& cells) {
  trace::CellSystem system;
  system.cell_count = {cell_count, cell_count, 1};
  for (const auto& [x, y] : cells) system.cells.push_back({x - 1, y - 1, 0});
  return system;
}

trace::CellSystem sorting_system() {
  return square(8, {{4, 7}, {5, 8}, {4, 6}, {5, 7}, {4, 5}, {5, 6}, {3, 7}, {6, 6}});
}

BookExample direct_check_example() {
  return {"eq. 3.10",
          "The book gives no example of its own here; these are the 8 elements of Figure 3.21.",
          sorting_system(),
          {}};
}

BookExample binary_tree_example() {
  return {"Figures 3.11 to 3.14",
          "The book gives the list of one cell, that of elements 3, 5, 7 and 9; here it is cell "
          "(2, 3) of 4 x 4, at level 5 below the root at level 1, and the other elements have "
          "cells of their own.",
          square(4, {{4, 4}, {1, 1}, {2, 3}, {3, 1}, {2, 3}, {1, 4}, {2, 3}, {4, 1}, {2, 3}}),
          {}};
}

BookExample screening_array_example() {
  return {"Figures 3.19 and 3.20, eq. 3.31",
          "",
          square(10, {{5, 7}, {5, 7}, {2, 7}, {5, 7}, {2, 7}, {5, 6}, {2, 7}, {6, 6}, {2, 7}}),
          {}};
}

BookExample sorting_array_example() {
  return {"Figures 3.21 to 3.38", "", sorting_system(), {{4, 6, -1}}};
}

/// A cell with neighbors beside, behind and below it, two layers in all, and one far away.
trace::CellSystem space_system() {
  trace::CellSystem system;
  system.dimensions = 3;
  system.cell_count = {3, 3, 3};
  system.cells = {{1, 1, 1}, {0, 1, 1}, {1, 0, 1}, {2, 2, 0}, {1, 1, 0}, {0, 0, 2}};
  return system;
}

BookExample munjiza_nbs_example() {
  trace::CellSystem system = sorting_system();
  system.cell_count = {10, 10, 1};
  system.cells.push_back({2, 5, 0});
  system.cells.push_back({3, 6, 0});
  return {
      "Figures 3.40 to 3.44",
      "The book does not say in which column of row 6 element 9 lies; column 3 is inferred from "
      "its dot in Figure 3.40, left of element 3.",
      std::move(system),
      {},
      space_system()};
}

/// Figures 3.28 to 3.38.
std::string partition_text() {
  const std::vector<std::int32_t> before{3, 16, 7, 11, 2, 14, 5, 9, 4, 8, 12, 6, 13, 15, 1, 10};
  const trace::Partition after = trace::first_partition(before);
  const auto [lowest, highest] = std::minmax_element(before.begin(), before.end());
  const std::span<const std::int32_t> halves(after.values);
  std::string swaps;
  for (std::size_t k = 0; k < after.left_size; ++k) {
    if (after.values[k] == before[k]) continue;
    swaps += fmt::format("{}{} <-> {}", swaps.empty() ? "" : ", ", before[k], after.values[k]);
  }
  return fmt::format(
      "\npartition sort of 16 numbers, first split (Figures 3.28 to 3.38)\n"
      "  before  {}\n"
      "  middle  ({} + {}) / 2 = {}, truncated; left is what is below it\n"
      "  swaps   {}\n"
      "  after   {} | {}\n",
      fmt::join(before, " "), *lowest, *highest, (*lowest + *highest) / 2, swaps,
      fmt::join(halves.first(after.left_size), " "),
      fmt::join(halves.subspan(after.left_size), " "));
}

/// Figure 3.14: eq. 3.20 once more, on the arrays as they stand.
std::string insertion_text(const std::vector<RecordedStage>& stages) {
  const RecordedArray* next = last_array(stages, "E");
  const RecordedArray* heads = last_array(stages, "HEAD");
  constexpr std::int32_t a_member = 8;
  if (next == nullptr || heads == nullptr) return "";
  const auto head = std::find(heads->values.begin(), heads->values.end(), a_member);
  if (head == heads->values.end()) return "";
  std::string list;
  for (std::int32_t e = *head; e >= 0; e = next->values[static_cast<std::size_t>(e)]) {
    list += fmt::format(" -> {}", numbered(e, Numbering::from_one));
  }
  const std::int32_t old_head = numbered(*head, Numbering::from_one);
  return fmt::format(
      "\nthe list of cell (2, 3) (Figure 3.13): HEAD{}\n"
      "then element 1 comes into this cell (Figure 3.14): E[1] = HEAD = {}, then HEAD = 1\n"
      "  HEAD -> 1{}\n",
      list, old_head, list);
}

}  // namespace

BookExample book_example(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::direct_check:
      return direct_check_example();
    case Algorithm::binary_tree:
      return binary_tree_example();
    case Algorithm::screening_array:
      return screening_array_example();
    case Algorithm::sorting_array:
      return sorting_array_example();
    case Algorithm::munjiza_nbs:
      return munjiza_nbs_example();
    case Algorithm::rows:
    case Algorithm::automatic:
      break;
  }
  throw Error(ErrorCode::wrong_usage,
              fmt::format("the book has no example of {}; give FILE", name_of(algorithm)));
}

std::string book_supplement(Algorithm algorithm, const std::vector<RecordedStage>& stages) {
  if (algorithm == Algorithm::sorting_array) return partition_text();
  if (algorithm == Algorithm::binary_tree) return insertion_text(stages);
  return "";
}

}  // namespace abut::cli
