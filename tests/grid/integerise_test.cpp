// Cell numbers: from 0, below cell_count, few, whatever the elements.

#include "grid/integerised.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>
#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

template <int Dim>
void expect_cells_in_range(const grid::CellCoordinates<Dim>& cells) {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    std::int32_t largest = -1;
    for (const std::int32_t cell : cells.axis(axis)) {
      ASSERT_GE(cell, 0);
      ASSERT_LT(cell, cells.cell_count[axis]);
      largest = std::max(largest, cell);
    }
    ASSERT_EQ(largest + 1, cells.cell_count[axis]) << "the last cell is occupied";
  }
}

TEST(Integerise, NoElements) {
  base::DetectionContext context;
  const auto cells = integerise(std::vector<exact::Sphere<3>>{}, 0.0, context);
  EXPECT_EQ(cells.element_count(), 0u);
  EXPECT_EQ(cells.cell_count, (std::array<std::int32_t, 3>{0, 0, 0}));
}

TEST(Integerise, OneElementIsInCellZero) {
  for (const double x : {0.0, -0.0, 1e308, -1e308, 5e-324}) {
    for (const double radius : {0.0, 1.0, 1e308}) {
      EXPECT_EQ(cells_of({{x}, radius, 0.0}), (std::vector<std::int32_t>{0, 1})) << x;
    }
  }
}

TEST(Integerise, AllInOneCell) {
  EXPECT_EQ(cells_of({{3.5, 3.5, 3.5}, 1.0, 0.0}), (std::vector<std::int32_t>{0, 0, 0, 1}));
  EXPECT_EQ(cells_of({{3.5, 3.5, 3.5}, 0.0, 0.0}), (std::vector<std::int32_t>{0, 0, 0, 1}));
  EXPECT_EQ(cells_of({{-1.0, 0.0, 0.9}, 1.0, 0.0}), (std::vector<std::int32_t>{0, 0, 0, 1}));
}

TEST(Integerise, CellsAreAHairLargerThanTheReach) {
  // At x = 1 the cell of side 1 + 2^-19 is not full; without the margin it would begin there.
  EXPECT_EQ(cells_of({{0.0, 1.0, 1.0 + 0x1p-18, 2.0}, 0.5, 0.0}),
            (std::vector<std::int32_t>{0, 0, 1, 1, 2}));
}

TEST(Integerise, TheReachIsThatOfTheTwoLargestAndTheMargin) {
  std::vector<exact::Sphere<2>> discs{{{0, 0}, 3.0}, {{6.0, 0}, 1.0}, {{11.9, 0}, 0.0}};
  base::DetectionContext context;
  // Cells of 3 + 1 + 2 = 6 and a hair.
  const auto cells = integerise(discs, 2.0, context);
  EXPECT_EQ(cells.x(0), 0);
  EXPECT_EQ(cells.x(1), 0);
  EXPECT_EQ(cells.x(2), 1);
  EXPECT_EQ(cells.cell_count[0], 2);
}

TEST(Integerise, NegativeCoordinatesCountFromTheLowest) {
  EXPECT_EQ(cells_of({{-3.0, -5.0, -0.5, 0.5, -0.0, 0.0}, 0.5, 0.0}),
            (std::vector<std::int32_t>{1, 0, 4, 5, 4, 4, 6}));
}

TEST(Integerise, PointsWithoutReachAreSpreadOut) {
  scenes::Random random(91);
  std::vector<exact::Sphere<3>> points(1000);
  for (auto& point : points) {
    for (double& x : point.center) x = random.uniform(-1.0, 1.0);
  }
  base::DetectionContext context;
  const auto cells = integerise(points, 0.0, context);
  expect_cells_in_range(cells);
  for (const std::int32_t count : cells.cell_count) {
    EXPECT_GE(count, 9);
    EXPECT_LE(count, 11);
  }
}

TEST(Integerise, OneFarOutlierTakesOneCellMore) {
  for (const double far : {1e15, 1e100, 1e308, -1e308}) {
    Line line{{}, 0.5, 0.0};
    for (int k = 0; k < 100; ++k) line.x.push_back(k);
    line.x.push_back(far);
    const std::vector<std::int32_t> cells = cells_of(line);
    EXPECT_LE(cells.back(), 2 * 101);
    for (std::size_t k = 1; k < 100; ++k) {
      ASSERT_GE(cells[k], cells[k - 1]) << "order is kept";
      ASSERT_LE(cells[k], cells[k - 1] + 1);
    }
    EXPECT_GT(std::abs(cells[100] - cells[far > 0 ? 99 : 0]), 1) << "the outlier has no neighbours";
  }
}

TEST(Integerise, CellNumbersFollowTheElementsOnAnyScale) {
  scenes::Random random(92);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<exact::Sphere<3>> spheres(1 + random.below(100));
    const std::uint64_t spread = random.below(2000);
    for (auto& sphere : spheres) {
      for (double& x : sphere.center) {
        const int exponent = -1000 + static_cast<int>(random.below(spread + 1));
        x = std::ldexp(random.uniform(-1.0, 1.0), exponent);
      }
      sphere.radius = std::ldexp(1.0, -1060 + static_cast<int>(random.below(100)));
    }
    base::DetectionContext context;
    const auto cells = integerise(spheres, 0.0, context);
    ASSERT_NO_FATAL_FAILURE(expect_cells_in_range(cells)) << "seed 92, trial " << trial;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double most = cells.uncollapsed_cell_count[axis] > 0x1p30
                              ? 2.0 * static_cast<double>(spheres.size())
                              : cells.uncollapsed_cell_count[axis];
      ASSERT_LE(cells.cell_count[axis], most) << "seed 92, trial " << trial;
      for (std::size_t i = 0; i < spheres.size(); ++i) {
        for (std::size_t j = 0; j < spheres.size(); ++j) {
          if (spheres[i].center[axis] < spheres[j].center[axis]) {
            ASSERT_LE(cells.axis(axis)[i], cells.axis(axis)[j]) << "cells ascend with x";
          }
        }
      }
    }
  }
}

TEST(Integerise, TheUncollapsedCountTellsHowLongTheAxisIs) {
  base::DetectionContext context;
  const std::vector<exact::Sphere<2>> discs{{{0, 0}, 0.5}, {{1e12, 10.0}, 0.5}};
  const auto cells = integerise(discs, 0.0, context);
  EXPECT_EQ(cells.cell_count[0], 3);
  EXPECT_NEAR(cells.uncollapsed_cell_count[0], 1e12, 1e7);
  EXPECT_EQ(cells.cell_count[1], 10);
  EXPECT_EQ(cells.uncollapsed_cell_count[1], 10.0);
}

TEST(Integerise, RefusesWhatTheMemoryBoundDoesNotHold) {
  base::DetectionContext context(100, {});
  const std::vector<exact::Sphere<2>> discs(20, {{1, 1}, 1});
  EXPECT_THROW(static_cast<void>(integerise(discs, 0.0, context)), Error);
  EXPECT_EQ(context.memory.held(), 0u);
}

}  // namespace
}  // namespace abut::testing
