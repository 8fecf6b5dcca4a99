#pragma once

#include <abut/pair.hpp>
#include <abut/trace.hpp>
#include "scenes/random.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace abut::testing {

/// n x n (x n) cells with one element in each.
[[nodiscard]] inline trace::CellSystem full_block(int dimensions, std::int32_t n) {
  trace::CellSystem system;
  system.dimensions = dimensions;
  system.cell_count = {n, n, dimensions == 3 ? n : 1};
  for (std::int32_t x = 0; x < n; ++x) {
    for (std::int32_t y = 0; y < n; ++y) {
      for (std::int32_t z = 0; z < system.cell_count[2]; ++z) system.cells.push_back({x, y, z});
    }
  }
  return system;
}

/// Few cells and many elements, or the reverse; often with border cells, one row or one column.
[[nodiscard]] inline trace::CellSystem random_cells(int dimensions, scenes::Random& random) {
  trace::CellSystem system;
  system.dimensions = dimensions;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimensions); ++axis) {
    system.cell_count[axis] = static_cast<std::int32_t>(1 + random.below(9));
  }
  system.cells.resize(random.below(60));
  for (auto& cell : system.cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::int32_t>(
          random.below(static_cast<std::size_t>(system.cell_count[axis])));
    }
  }
  return system;
}

/// All pairs in equal or adjacent cells, ascending: no mask, no lists, no grid.
[[nodiscard]] inline std::vector<ContactPair> adjacent_pairs(const trace::CellSystem& system) {
  std::vector<ContactPair> pairs;
  for (ElementIndex i = 0; i < system.cells.size(); ++i) {
    for (ElementIndex j = i + 1; j < system.cells.size(); ++j) {
      bool adjacent = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        adjacent = adjacent && std::abs(system.cells[i][axis] - system.cells[j][axis]) <= 1;
      }
      if (adjacent) pairs.push_back({i, j});
    }
  }
  return pairs;
}

/// All pairs, ascending.
[[nodiscard]] inline std::vector<ContactPair> all_pairs(const trace::CellSystem& system) {
  std::vector<ContactPair> pairs;
  for (ElementIndex i = 0; i < system.cells.size(); ++i) {
    for (ElementIndex j = i + 1; j < system.cells.size(); ++j) pairs.push_back({i, j});
  }
  return pairs;
}

}  // namespace abut::testing
