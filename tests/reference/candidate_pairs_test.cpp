// Every algorithm delivers each pair of elements in equal or adjacent cells exactly once.

#include "book/recorded_trace.hpp"
#include "reference/cell_systems.hpp"
#include "scenes/random.hpp"
#include "support/algorithm_list.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

std::vector<ContactPair> expected_pairs(Algorithm algorithm, const trace::CellSystem& system) {
  return algorithm == Algorithm::direct_check ? all_pairs(system) : adjacent_pairs(system);
}

class CandidatePairs : public ::testing::TestWithParam<AlgorithmInfo> {
 protected:
  Algorithm algorithm = GetParam().algorithm;

  void expect_right(const trace::CellSystem& system, const std::string& what) {
    const auto found = record(algorithm, system).sorted_candidates();
    ASSERT_EQ(found, expected_pairs(algorithm, system)) << what;
  }
};

TEST_P(CandidatePairs, FullBlocks) {
  // Faces, edges and corners of n x n and n x n x n cells, one element in each.
  const std::size_t expected[2][3] = {{6, 20, 42}, {28, 158, 468}};
  for (const int dimensions : {2, 3}) {
    for (const std::int32_t n : {2, 3, 4}) {
      const trace::CellSystem block = full_block(dimensions, n);
      const std::size_t elements = block.cells.size();
      const std::size_t count = algorithm == Algorithm::direct_check
                                    ? elements * (elements - 1) / 2
                                    : expected[dimensions - 2][n - 2];
      EXPECT_EQ(record(algorithm, block).candidates.size(), count) << dimensions << "D, n = " << n;
      expect_right(block, "full block");
    }
  }
}

TEST_P(CandidatePairs, RandomCells) {
  for (const int dimensions : {2, 3}) {
    scenes::Random random(1995);
    for (int trial = 0; trial < 200; ++trial) {
      ASSERT_NO_FATAL_FAILURE(expect_right(
          random_cells(dimensions, random),
          std::to_string(dimensions) + "D, seed 1995, trial " + std::to_string(trial)));
    }
  }
}

TEST_P(CandidatePairs, NoneOneTwoElements) {
  for (const int dimensions : {2, 3}) {
    trace::CellSystem system;
    system.dimensions = dimensions;
    expect_right(system, "no elements");
    system.cells = {{0, 0, 0}};
    expect_right(system, "one element");
    system.cells = {{0, 0, 0}, {0, 0, 0}};
    expect_right(system, "two elements in the only cell");
  }
}

TEST_P(CandidatePairs, AllInOneCell) {
  for (const int dimensions : {2, 3}) {
    trace::CellSystem system;
    system.dimensions = dimensions;
    system.cell_count = {3, 3, dimensions == 3 ? 3 : 1};
    system.cells.assign(30, {2, 2, dimensions == 3 ? 2 : 0});
    ASSERT_EQ(adjacent_pairs(system).size(), 30u * 29u / 2u);
    expect_right(system, "all in the last cell");
  }
}

TEST_P(CandidatePairs, OneRowAndOneColumn) {
  for (const std::size_t axis : {0u, 1u, 2u}) {
    trace::CellSystem system;
    system.dimensions = axis == 2 ? 3 : 2;
    system.cell_count[axis] = 7;
    for (std::int32_t k = 6; k >= 0; --k) {
      system.cells.push_back({0, 0, 0});
      system.cells.back()[axis] = k;
    }
    if (algorithm != Algorithm::direct_check) {
      EXPECT_EQ(record(algorithm, system).candidates.size(), 6u);
    }
    expect_right(system, "one line of cells along axis " + std::to_string(axis));
  }
}

TEST_P(CandidatePairs, CellsThatWrapAroundAreNotNeighbors) {
  // Without guards, the cell before the first of a row is the last of the row before it.
  trace::CellSystem system;
  system.cell_count = {3, 3, 1};
  system.cells = {{0, 2, 0}, {1, 0, 0}, {2, 2, 0}, {0, 0, 0}};
  expect_right(system, "2D");
  system.dimensions = 3;
  system.cell_count = {3, 3, 3};
  system.cells = {{0, 2, 2}, {1, 0, 0}, {2, 2, 2}, {0, 0, 0}, {1, 1, 2}, {1, 2, 0}, {2, 0, 0}};
  expect_right(system, "3D");
}

INSTANTIATE_TEST_SUITE_P(EveryAlgorithm, CandidatePairs,
                         ::testing::ValuesIn(abut::testing::traceable_algorithms()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace abut::testing
