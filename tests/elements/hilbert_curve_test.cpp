// The Hilbert curve: each cell once, each a neighbor of the one before.

#include "elements/hilbert_curve.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace abut::testing {
namespace {

/// Walks along the curve through all cells of a cube of 2^Bits cells a side.
template <int Dim, int Bits>
void expect_steps_to_neighbors() {
  constexpr std::uint32_t side = 1U << Bits;
  constexpr std::size_t count = std::size_t{1} << (Dim * Bits);
  std::vector<std::array<std::uint32_t, Dim>> cells(count);
  std::vector<int> visits(count);
  for (std::size_t k = 0; k < count; ++k) {
    std::array<std::uint32_t, Dim> cell{};
    std::size_t rest = k;
    for (std::uint32_t& number : cell) {
      number = static_cast<std::uint32_t>(rest % side);
      rest /= side;
    }
    const std::uint64_t number = elements::HilbertCurve<Dim, Bits>::number(cell);
    ASSERT_LT(number, count);
    cells[number] = cell;
    ++visits[number];
  }
  EXPECT_EQ(cells[0], (std::array<std::uint32_t, Dim>{}));
  for (std::size_t k = 0; k < count; ++k) {
    ASSERT_EQ(visits[k], 1) << k;
    if (k == 0) continue;
    std::uint32_t distance = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      distance += static_cast<std::uint32_t>(
          std::abs(static_cast<int>(cells[k][axis]) - static_cast<int>(cells[k - 1][axis])));
    }
    ASSERT_EQ(distance, 1U) << "at " << k << " of " << Dim << "D, " << Bits << " bits";
  }
}

TEST(HilbertCurve, GoesFromEachCellToANeighborAndMissesNone) {
  expect_steps_to_neighbors<2, 1>();
  expect_steps_to_neighbors<2, 2>();
  expect_steps_to_neighbors<2, 7>();
  expect_steps_to_neighbors<3, 1>();
  expect_steps_to_neighbors<3, 2>();
  expect_steps_to_neighbors<3, 5>();
}

/// Cells of the whole cube share the first digits of their numbers with the cell of a coarser one.
TEST(HilbertCurve, IsThatOfTheCoarserCellsToo) {
  using Fine = elements::HilbertCurve<3, 21>;
  using Coarse = elements::HilbertCurve<3, 2>;
  for (const std::uint32_t x : {0U, 1'234'567U, 2'097'151U}) {
    for (const std::uint32_t y : {0U, 765'432U, 2'097'151U}) {
      for (const std::uint32_t z : {0U, 1'048'576U, 2'097'151U}) {
        EXPECT_EQ(Fine::number({x, y, z}) >> (3 * 19), Coarse::number({x >> 19, y >> 19, z >> 19}));
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
