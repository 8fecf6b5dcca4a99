#pragma once

#include "scenes/random.hpp"

#include <abut/simplex_contacts.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {

/// Vertices and cells of Corners vertices each.
template <std::size_t Dim, std::size_t Corners, class Number = double, class Index = int>
struct SimplexSystem {
  std::vector<std::array<Number, Dim>> vertices;
  std::vector<std::array<Index, Corners>> cells;

  [[nodiscard]] SimplexView view() const {
    if constexpr (Dim == 2) {
      return simplices_2d(vertices, cells);
    } else {
      return simplices_3d(vertices, cells);
    }
  }
};

/// Cells on a lattice: many are flat, many touch. One in two has a vertex of an earlier cell.
template <std::size_t Dim, std::size_t Corners, class Number = double, class Index = int>
[[nodiscard]] SimplexSystem<Dim, Corners, Number, Index> random_system(std::size_t cells,
                                                                       std::uint64_t seed) {
  scenes::Random random(seed);
  SimplexSystem<Dim, Corners, Number, Index> system;
  const double dense = std::pow(static_cast<double>(cells), 1.0 / static_cast<double>(Dim));
  for (std::size_t k = 0; k < cells; ++k) {
    std::array<Number, Dim> corner{};
    for (Number& x : corner) x = static_cast<Number>(std::floor(random.uniform(0.0, 1.1 * dense)));
    std::array<Index, Corners> cell{};
    std::size_t filled = 0;
    if (k > 0 && random.below(2) == 0) {
      const std::size_t shared = random.below(system.vertices.size());
      corner = system.vertices[shared];
      cell[filled++] = static_cast<Index>(shared);
    }
    for (; filled < Corners; ++filled) {
      cell[filled] = static_cast<Index>(system.vertices.size());
      auto& vertex = system.vertices.emplace_back(corner);
      for (Number& x : vertex) x += static_cast<Number>(random.below(3));
    }
    system.cells.push_back(cell);
  }
  return system;
}

}  // namespace abut::testing
