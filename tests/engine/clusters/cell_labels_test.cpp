// Labels of coarse cells: one for each cell that is asked for, whichever workers ask at once.

#include "engine/clusters/cell_labels.hpp"
#include "scenes/random.hpp"
#include "support/nobody_asked.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace abut::testing {
namespace {

class CellLabelsTest : public ::testing::Test {
 protected:
  std::vector<std::uint32_t> cells_in_order() {
    std::vector<std::uint32_t> cells;
    for (const std::uint32_t label : labels_.in_order_of_cells(nobody_.work)) {
      cells.push_back(labels_.cell_of(label));
    }
    return cells;
  }

  NobodyAsked nobody_;
  base::MemoryMeter memory_;
  engine::CellLabels labels_{memory_};
};

TEST_F(CellLabelsTest, ACellKeepsItsLabel) {
  labels_.start(10);
  labels_.add_cells(100);
  EXPECT_EQ(labels_.label_of(40), 0u);
  EXPECT_EQ(labels_.label(40), 1u);
  EXPECT_EQ(labels_.label(7), 2u);
  EXPECT_EQ(labels_.label(40), 1u);
  EXPECT_EQ(labels_.label_of(7), 2u);
  EXPECT_EQ(labels_.cell_of(2), 7u);
  EXPECT_EQ(labels_.given(), 2u);
  EXPECT_FALSE(labels_.are_too_few());
}

TEST_F(CellLabelsTest, NoneIsGivenWhenThereAreNoMore) {
  labels_.start(2);
  labels_.add_cells(100);
  EXPECT_EQ(labels_.label(99), 1u);
  EXPECT_EQ(labels_.label(0), 2u);
  EXPECT_FALSE(labels_.are_too_few());
  EXPECT_EQ(labels_.label(1), 0u);
  EXPECT_TRUE(labels_.are_too_few());
  EXPECT_EQ(labels_.label(99), 1u);
  EXPECT_EQ(labels_.given(), 2u);
}

/// What follows from labels must not depend on who came first.
TEST_F(CellLabelsTest, NewOnesComeInTheOrderOfTheirCells) {
  labels_.start(10);
  labels_.add_cells(100);
  for (const std::uint32_t cell : {50u, 3u, 99u, 4u}) static_cast<void>(labels_.label(cell));
  EXPECT_EQ(cells_in_order(), (std::vector<std::uint32_t>{3, 4, 50, 99}));
  EXPECT_TRUE(cells_in_order().empty());
  labels_.add_cells(200);
  for (const std::uint32_t cell : {180u, 50u, 100u}) static_cast<void>(labels_.label(cell));
  EXPECT_EQ(cells_in_order(), (std::vector<std::uint32_t>{100, 180}));
  EXPECT_EQ(labels_.label_of(3), 2u) << "cells that are added change no label";
}

TEST_F(CellLabelsTest, ASecondStartKnowsNothingOfTheFirst) {
  for (int turn = 0; turn < 2; ++turn) {
    labels_.start(5);
    labels_.add_cells(30);
    EXPECT_EQ(labels_.label_of(12), 0u);
    EXPECT_EQ(labels_.label(12), 1u);
    labels_.add_cells(60);
    EXPECT_EQ(labels_.label_of(40), 0u);
    EXPECT_EQ(labels_.label(40), 2u);
    EXPECT_EQ(cells_in_order(), (std::vector<std::uint32_t>{12, 40}));
  }
}

TEST_F(CellLabelsTest, WorkersThatAskAtOnceGetTheSameLabels) {
  constexpr std::uint32_t cells = 20000;
  constexpr std::size_t workers = 4;
  labels_.start(workers * cells);
  labels_.add_cells(cells);
  std::vector<std::vector<std::uint32_t>> got(workers, std::vector<std::uint32_t>(cells));
  std::vector<std::thread> threads;
  for (std::size_t worker = 0; worker < workers; ++worker) {
    threads.emplace_back([&, worker] {
      scenes::Random random(5 + worker % 2);
      for (std::uint32_t k = 0; k < cells; ++k) {
        const auto cell = static_cast<std::uint32_t>(random.below(cells));
        got[worker][cell] = labels_.label(cell);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  std::set<std::uint32_t> labeled;
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    const std::uint32_t label = labels_.label_of(cell);
    if (label != 0) {
      EXPECT_EQ(labels_.cell_of(label), cell);
      labeled.insert(cell);
    }
    for (const auto& of_worker : got) EXPECT_TRUE(of_worker[cell] == 0 || of_worker[cell] == label);
  }
  EXPECT_EQ(cells_in_order(), std::vector<std::uint32_t>(labeled.begin(), labeled.end()));
}

}  // namespace
}  // namespace abut::testing
