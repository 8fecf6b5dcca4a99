#include "periodic/moved_cells.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace abut::testing {
namespace {

using periodic::MovedCells;

TEST(MovedCells, FitAWordAndSoDoTheirDifferences) {
  constexpr std::int32_t most = MovedCells::most_packed;
  const std::int32_t numbers[] = {-most, -1, 0, 1, 17, most};
  for (const std::int32_t x : numbers) {
    for (const std::int32_t y : numbers) {
      for (const std::int32_t z : numbers) {
        const lattice::CellsMoved cells{x, y, z};
        const std::uint32_t word = MovedCells::packed(cells);
        ASSERT_EQ(MovedCells::unpacked(word), cells);
        for (const std::int32_t other : numbers) {
          const std::uint32_t second = MovedCells::packed({other, -other, z});
          const auto difference = MovedCells::unpacked(MovedCells::difference(word, second));
          ASSERT_EQ(difference, (lattice::CellsMoved{x - other, y + other, 0}));
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
