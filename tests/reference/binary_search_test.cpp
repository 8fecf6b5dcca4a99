// The search of the sorting algorithm: halvings, at most ceil(log2 N) of them.

#include "book/recorded_trace.hpp"
#include "reference/cell_systems.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>

namespace abut::testing {
namespace {

using Cell = std::array<std::int32_t, 3>;

Cell cell_at(const ShownStage& sorted, std::size_t position) {
  Cell cell{sorted.array("X").values[position], sorted.array("Y").values[position], -1};
  if (sorted.arrays.size() == 4) cell[2] = sorted.array("Z").values[position];
  return cell;
}

/// What is wrong with a search; empty if nothing.
std::string fault_of(const ShownStage& search, const ShownStage& sorted, std::size_t size) {
  if (search.search_steps.size() > std::bit_width(size - 1)) return "more than ceil(log2 N) steps";
  std::size_t first = 0;
  std::size_t last = size;
  for (const trace::SearchStep& step : search.search_steps) {
    if (step.first != first || step.last != last) return "a step does not begin where one ended";
    if (step.middle <= first || step.middle >= last) return "a split without two parts";
    const bool keeps_left = step.kept_first == first && step.kept_last == step.middle;
    const bool keeps_right = step.kept_first == step.middle && step.kept_last == last;
    if (!keeps_left && !keeps_right) return "something else than a part was kept";
    first = step.kept_first;
    last = step.kept_last;
  }
  if (last - first != 1) return "the search stops before one position is left";
  for (std::size_t p = 0; p < first; ++p) {
    if (cell_at(sorted, p) == search.cell) return "an earlier position holds the cell";
  }
  if (cell_at(sorted, first) == search.cell) return "";
  for (std::size_t p = first; p < size; ++p) {
    if (cell_at(sorted, p) == search.cell) return "the cell is there and was not found";
  }
  return "";
}

TEST(BinarySearch, EndsAtTheFirstElementOfTheCellWithinLog2NSteps) {
  std::size_t found = 0;
  for (const int dimensions : {2, 3}) {
    scenes::Random random(1946);
    for (int trial = 0; trial < 40; ++trial) {
      const trace::CellSystem system = random_cells(dimensions, random);
      const auto recorded = record(Algorithm::sorting_array, system);
      const ShownStage& sorted = recorded.stage_called("step 2");
      for (const ShownStage* search : recorded.stages_called("binary search")) {
        ASSERT_EQ(fault_of(*search, sorted, system.cells.size()), "")
            << dimensions << "D, seed 1946, trial " << trial;
        ++found;
      }
    }
  }
  EXPECT_GT(found, 5000u);
}

TEST(BinarySearch, SortedArraysAscendWithTheElementAsLastKey) {
  for (const int dimensions : {2, 3}) {
    scenes::Random random(1947);
    for (int trial = 0; trial < 100; ++trial) {
      const trace::CellSystem system = random_cells(dimensions, random);
      const auto recorded = record(Algorithm::sorting_array, system);
      const ShownStage& sorted = recorded.stage_called("step 2");
      const auto& D = sorted.array("D").values;
      for (std::size_t p = 0; p < D.size(); ++p) {
        Cell own = system.cells.at(static_cast<std::size_t>(D[p]));
        if (dimensions == 2) own[2] = -1;
        ASSERT_EQ(cell_at(sorted, p), own) << "seed 1947, trial " << trial;
        if (p == 0) continue;
        ASSERT_LT(std::pair(cell_at(sorted, p - 1), D[p - 1]), std::pair(cell_at(sorted, p), D[p]))
            << "seed 1947, trial " << trial;
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
