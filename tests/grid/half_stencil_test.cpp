#include "grid/half_stencil.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <set>

namespace abut::testing {
namespace {

/// The mask and its reflection are disjoint and together all neighbours of a cell.
template <int Dim>
void expect_half_of_all_neighbors(std::size_t neighbors) {
  using Offset = std::array<std::int32_t, Dim>;
  std::set<Offset> both;
  for (const Offset& offset : grid::HalfStencil<Dim>::offsets) {
    Offset reflected = offset;
    for (std::int32_t& step : reflected) step = -step;
    EXPECT_TRUE(both.insert(offset).second);
    EXPECT_TRUE(both.insert(reflected).second);
    for (const std::int32_t step : offset) EXPECT_LE(std::abs(step), 1);
  }
  EXPECT_EQ(both.size(), neighbors);
  EXPECT_FALSE(both.contains(Offset{})) << "the central cell is not its own neighbour";
}

TEST(HalfStencil, IsHalfOfTheNeighborsIn2d) {
  expect_half_of_all_neighbors<2>(8);
}
TEST(HalfStencil, IsHalfOfTheNeighborsIn3d) {
  expect_half_of_all_neighbors<3>(26);
}

TEST(HalfStencil, IsTheMaskOfTheBook) {
  // Eq. 3.39; eq. 3.73: the layer below whole, and the mask of 2D in the central layer.
  const auto& flat = grid::HalfStencil<2>::offsets;
  EXPECT_EQ(std::set(flat.begin(), flat.end()),
            (std::set<std::array<std::int32_t, 2>>{{-1, -1}, {0, -1}, {1, -1}, {-1, 0}}));
  std::size_t below = 0;
  for (const auto& offset : grid::HalfStencil<3>::offsets) {
    if (offset[2] == -1) {
      ++below;
      continue;
    }
    EXPECT_EQ(offset[2], 0);
    EXPECT_NE(std::find(flat.begin(), flat.end(), std::array{offset[0], offset[1]}), flat.end());
  }
  EXPECT_EQ(below, 9u);
}

}  // namespace
}  // namespace abut::testing
