// Nodes and lists of the binary tree.

#include "book/recorded_trace.hpp"
#include "reference/cell_systems.hpp"
#include "scenes/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace abut::testing {
namespace {

using Numbers = std::vector<std::int32_t>;

std::size_t index(std::int32_t number) {
  return static_cast<std::size_t>(number);
}

std::size_t occupied_cells(const trace::CellSystem& system) {
  return std::set(system.cells.begin(), system.cells.end()).size();
}

std::size_t level_count(const trace::CellSystem& system) {
  const std::int32_t widest = *std::max_element(system.cell_count.begin(), system.cell_count.end());
  const auto bits = std::bit_width(static_cast<std::uint32_t>(widest - 1));
  return static_cast<std::size_t>(bits) * static_cast<std::size_t>(system.dimensions);
}

TEST(BinaryTree, NodesOnlyForOccupiedCellsAndAtMostNTimesB) {
  for (const int dimensions : {2, 3}) {
    scenes::Random random(1973);
    for (int trial = 0; trial < 100; ++trial) {
      SCOPED_TRACE("seed 1973, trial " + std::to_string(trial));
      const trace::CellSystem system = random_cells(dimensions, random);
      if (system.cells.empty()) continue;
      const auto recorded = record(Algorithm::binary_tree, system);
      const ShownStage& built = recorded.stage_called("build");
      const std::size_t leaves = built.array("HEAD").values.size();
      const std::size_t inner = built.array("left node").values.size();
      EXPECT_EQ(leaves, occupied_cells(system));
      EXPECT_EQ(built.array("right node").values.size(), inner);
      // The root and at most b nodes below it for each element.
      EXPECT_LE(leaves + inner, 1 + system.cells.size() * level_count(system));
      // Every node but the root is the child of one: the tree wastes none.
      std::size_t children = 0;
      for (const std::string_view side : {"left node", "right node"}) {
        for (const std::int32_t child : built.array(side).values) children += child == -1 ? 0 : 1;
      }
      EXPECT_EQ(children + 1, leaves + inner);
    }
  }
}

TEST(BinaryTree, ListsOfTheLeavesDescendAndHoldEveryElementOnce) {
  for (const int dimensions : {2, 3}) {
    scenes::Random random(1974);
    for (int trial = 0; trial < 100; ++trial) {
      SCOPED_TRACE("seed 1974, trial " + std::to_string(trial));
      const trace::CellSystem system = random_cells(dimensions, random);
      if (system.cells.empty()) continue;
      const auto recorded = record(Algorithm::binary_tree, system);
      const ShownStage& built = recorded.stage_called("build");
      const Numbers& E = built.array("E").values;
      std::set<std::int32_t> listed;
      for (const std::int32_t head : built.array("HEAD").values) {
        auto before = static_cast<std::int32_t>(E.size());
        for (std::int32_t e = head; e != -1; e = E.at(index(e))) {
          EXPECT_LT(e, before);
          before = e;
          EXPECT_EQ(system.cells.at(index(e)), system.cells.at(index(head)));
          EXPECT_TRUE(listed.insert(e).second) << "element " << e << " twice";
        }
      }
      EXPECT_EQ(listed.size(), system.cells.size());
    }
  }
}

TEST(BinaryTree, OneCellIsOneLeafWithoutNodes) {
  trace::CellSystem system;
  system.cells.assign(4, {0, 0, 0});
  const auto recorded = record(Algorithm::binary_tree, system);
  const ShownStage& built = recorded.stage_called("build");
  EXPECT_EQ(built.array("HEAD").values, Numbers{3});
  EXPECT_TRUE(built.array("left node").values.empty());
}

}  // namespace
}  // namespace abut::testing
