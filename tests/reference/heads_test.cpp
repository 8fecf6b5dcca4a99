// Lists are in descending number where the book says so, hold exactly what the stage treats, and
// are empty after a detection.

#include "book/recorded_trace.hpp"
#include "reference/cell_systems.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using Numbers = std::vector<std::int32_t>;

Numbers list(std::int32_t head, const Numbers& next) {
  Numbers elements;
  for (std::int32_t e = head; e != -1; e = next.at(static_cast<std::size_t>(e))) {
    elements.push_back(e);
    if (elements.size() > next.size()) throw std::out_of_range("the list never ends");
  }
  return elements;
}

bool descends(const Numbers& elements) {
  return std::is_sorted(elements.begin(), elements.end(), std::greater<>());
}

/// Elements whose cell satisfies the condition, ascending.
template <class Condition>
Numbers elements_where(const trace::CellSystem& system, Condition condition) {
  Numbers elements;
  for (std::size_t k = 0; k < system.cells.size(); ++k) {
    if (condition(system.cells[k])) elements.push_back(static_cast<std::int32_t>(k));
  }
  return elements;
}

Numbers ascending(Numbers elements) {
  std::sort(elements.begin(), elements.end());
  return elements;
}

/// Each list of `heads` holds exactly the elements whose cell has `rows` and x = its number.
template <class Condition>
void expect_cell_lists(const trace::CellSystem& system, const Numbers& heads, const Numbers& next,
                       Condition rows) {
  for (std::size_t x = 0; x < heads.size(); ++x) {
    const Numbers expected = elements_where(system, [&](const auto& cell) {
      return cell[0] == static_cast<std::int32_t>(x) && rows(cell);
    });
    ASSERT_EQ(ascending(list(heads[x], next)), expected) << "cell " << x;
  }
}

template <class Check>
void for_random_systems(int dimensions, Check check) {
  scenes::Random random(1998);
  for (int trial = 0; trial < 60; ++trial) {
    SCOPED_TRACE("seed 1998, trial " + std::to_string(trial));
    const trace::CellSystem system = random_cells(dimensions, random);
    ASSERT_NO_FATAL_FAILURE(check(system));
  }
}

TEST(Heads, ScreeningListsDescendAndAreEmptiedAfterwards) {
  for (const int dimensions : {2, 3}) {
    for_random_systems(dimensions, [](const trace::CellSystem& system) {
      const auto recorded = record(Algorithm::screening_array, system);
      const Numbers& C = recorded.stage_called("step 1").array("C").values;
      const Numbers& E = recorded.stage_called("step 1").array("E").values;
      std::size_t listed = 0;
      for (const std::int32_t head : C) {
        const Numbers elements = list(head, E);
        EXPECT_TRUE(descends(elements));
        listed += elements.size();
      }
      EXPECT_EQ(listed, system.cells.size());
      const ShownStage& emptied = recorded.stage_called("step 3");
      EXPECT_EQ(emptied.array("C").values, Numbers(C.size(), -1));
      EXPECT_EQ(recorded.last_array().symbol, "E");
      EXPECT_EQ(recorded.last_array().values, Numbers(E.size(), -1));
    });
  }
}

TEST(Heads, NbsIn2dHoldsTwoRowsAndNothingLeftOver) {
  for_random_systems(2, [](const trace::CellSystem& system) {
    const auto recorded = record(Algorithm::munjiza_nbs, system);
    const ShownStage& first = recorded.stage_called("stage 1");
    for (const std::int32_t head : first.array("B").values) {
      EXPECT_TRUE(descends(list(head, first.array("Y").values)));
    }
    for (const ShownStage* shown : recorded.stages_called("central row")) {
      const std::int32_t iy = shown->cell[1];
      const Numbers& X = shown->array("X").values;
      ASSERT_NO_FATAL_FAILURE(expect_cell_lists(system, shown->array("A[0]").values, X,
                                                [&](const auto& cell) { return cell[1] == iy; }));
      ASSERT_NO_FATAL_FAILURE(
          expect_cell_lists(system, shown->array("A[1]").values, X,
                            [&](const auto& cell) { return cell[1] == iy - 1; }));
    }
    EXPECT_EQ(recorded.last_array().symbol, "B");
    EXPECT_EQ(recorded.last_array().values,
              Numbers(static_cast<std::size_t>(system.cell_count[1]), -1));
  });
}

TEST(Heads, NbsIn3dHoldsTwoLayersAndFiveRowsAndNothingLeftOver) {
  for_random_systems(3, [](const trace::CellSystem& system) {
    const auto recorded = record(Algorithm::munjiza_nbs, system);
    const ShownStage& first = recorded.stage_called("stage 1");
    for (const std::int32_t head : first.array("C").values) {
      EXPECT_TRUE(descends(list(head, first.array("Z").values)));
    }
    for (const ShownStage* shown : recorded.stages_called("central layer")) {
      const std::int32_t iz = shown->cell[2];
      const Numbers& Y = shown->array("Y").values;
      for (const std::int32_t set : {0, 1}) {
        const Numbers& B = shown->array(set == 0 ? "B[0]" : "B[1]").values;
        for (std::size_t y = 0; y < B.size(); ++y) {
          const Numbers expected = elements_where(system, [&](const auto& cell) {
            return cell[1] == static_cast<std::int32_t>(y) && cell[2] == iz - set;
          });
          ASSERT_EQ(ascending(list(B[y], Y)), expected) << "set " << set << ", row " << y;
        }
      }
    }
    for (const ShownStage* shown : recorded.stages_called("central row")) {
      const std::int32_t iy = shown->cell[1];
      const std::int32_t iz = shown->cell[2];
      const Numbers& X = shown->array("X").values;
      ASSERT_NO_FATAL_FAILURE(
          expect_cell_lists(system, shown->array("A[0]").values, X,
                            [&](const auto& cell) { return cell[1] == iy && cell[2] == iz; }));
      // The four rows of eq. 3.79.
      ASSERT_NO_FATAL_FAILURE(
          expect_cell_lists(system, shown->array("A[1]").values, X, [&](const auto& cell) {
            return (cell[1] == iy - 1 && cell[2] == iz) ||
                   (std::abs(cell[1] - iy) <= 1 && cell[2] == iz - 1);
          }));
    }
    EXPECT_EQ(recorded.last_array().symbol, "C");
    EXPECT_EQ(recorded.last_array().values,
              Numbers(static_cast<std::size_t>(system.cell_count[2]), -1));
  });
}

TEST(Heads, EveryNonEmptyRowAndCellIsCentralOnce) {
  for (const int dimensions : {2, 3}) {
    for_random_systems(dimensions, [](const trace::CellSystem& system) {
      const auto recorded = record(Algorithm::munjiza_nbs, system);
      std::vector<std::array<std::int32_t, 3>> treated;
      for (const ShownStage* shown : recorded.stages_called("central cell")) {
        treated.push_back(shown->cell);
        if (system.dimensions == 2) treated.back()[2] = 0;
      }
      std::sort(treated.begin(), treated.end());
      auto occupied = system.cells;
      std::sort(occupied.begin(), occupied.end());
      occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
      EXPECT_EQ(treated, occupied);
    });
  }
}

}  // namespace
}  // namespace abut::testing
