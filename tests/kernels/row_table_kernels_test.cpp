// Tables of rows, and counts of layers, in vectors against plain sums.

#include "kernels/layers/layer_kernels.hpp"

#include "scenes/random.hpp"
#include "support/rows_variants.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

/// Stands behind what a kernel may write.
constexpr std::uint32_t untouched = 0xdeadbeef;

class RowTableKernels : public ::testing::Test {
 protected:
  template <class Body>
  static void at_each_level(const Body& body) {
    for (const Simd level : simd_levels_here()) {
      SCOPED_TRACE(std::string(name_of(level)));
      body(kernels::layer_kernels(level));
    }
  }

  Random random_{20261130};
};

/// Counts of which one in `spacing` is not 0, but for a stretch in which all are.
std::vector<std::uint32_t> counts_with_gap(Random& random, std::size_t size,
                                           std::uint64_t spacing) {
  std::vector<std::uint32_t> counts(size);
  const std::size_t gap = random.below(size + 1);
  const std::size_t end_of_gap = gap + random.below(100);
  for (std::size_t k = 0; k < size; ++k) {
    const bool is_empty = (k >= gap && k < end_of_gap) || random.below(spacing) != 0;
    counts[k] = is_empty ? 0 : static_cast<std::uint32_t>(1 + random.below(1000));
  }
  return counts;
}

TEST_F(RowTableKernels, CountsBecomePlaces) {
  at_each_level([&](const kernels::LayerKernels& kernels) {
    for (std::size_t size = 0; size < 300; ++size) {
      for (const std::uint64_t spacing : {1U, 3U, 40U}) {
        SCOPED_TRACE(std::to_string(size) + " counts, one in " + std::to_string(spacing));
        std::vector<std::uint32_t> table = counts_with_gap(random_, size, spacing);
        std::vector<std::uint32_t> places;
        const auto first = static_cast<std::uint32_t>(random_.below(1000));
        std::uint32_t place = first;
        for (const std::uint32_t count : table) {
          places.push_back(place);
          place += count;
        }
        table.push_back(untouched);
        places.push_back(untouched);
        EXPECT_EQ(kernels.turn_into_places(table.data(), size, first), place);
        EXPECT_EQ(table, places);
      }
    }
  });
}

/// Places are numbers of 32 bits: the highest bit is one of them.
TEST_F(RowTableKernels, PlacesHaveAllBits) {
  at_each_level([](const kernels::LayerKernels& kernels) {
    std::vector<std::uint32_t> table(70, 0x0300'0000);
    const std::uint32_t end = kernels.turn_into_places(table.data(), table.size(), 5);
    EXPECT_EQ(end, 5 + 70 * 0x0300'0000U);
    for (std::uint32_t k = 0; k < 70; ++k) EXPECT_EQ(table[k], 5 + k * 0x0300'0000U);
  });
}

/// Records whose rows and columns are below 2^bits.
std::vector<kernels::PositionRecord> records_with(Random& random, std::size_t count,
                                                  const kernels::RowMap& rows, int bits) {
  std::vector<kernels::PositionRecord> records(count);
  for (kernels::PositionRecord& record : records) {
    for (int axis = 0; axis < 3; ++axis) {
      const int shift = axis == rows.row_axis ? rows.column_shift : rows.row_shift;
      record.position[axis] =
          static_cast<std::int32_t>(random.below(std::uint64_t{1} << (shift + bits)));
    }
    record.number = static_cast<std::uint32_t>(random.below(1 << 20));
  }
  return records;
}

TEST_F(RowTableKernels, RecordsAreCountedByEntry) {
  constexpr int bits = 4;
  constexpr std::uint32_t row_length = 19;
  for (const kernels::RowMap& rows : {kernels::RowMap{0, 1, 20, 22, ~0U},
                                      {1, 2, 18, 20, ~0U},
                                      {2, 0, 26, 25, ~0U},
                                      {0, 1, 24, 20, 7U}}) {
    for (const std::size_t count : {0U, 1U, 3U, 7U, 8U, 9U, 64U, 333U}) {
      SCOPED_TRACE(std::to_string(count) + " records, rows along axis " +
                   std::to_string(rows.row_axis));
      const auto records = records_with(random_, count, rows, bits);
      const kernels::EntryMap map{rows, row_length, 3};
      std::vector<std::uint32_t> entries(count + 1, untouched);
      std::vector<std::uint32_t> table(row_length * (1 << bits) + 3, 10);
      std::vector<std::uint32_t> expected = table;
      for (std::size_t k = 0; k < count; ++k) {
        const auto row =
            static_cast<std::uint32_t>(records[k].position[rows.next_row_axis] >> rows.row_shift);
        const auto column =
            static_cast<std::uint32_t>(records[k].position[rows.row_axis] >> rows.column_shift);
        entries[k] = (row & rows.row_mask) * row_length + column + 3;
        ++expected[entries[k]];
      }
      at_each_level([&](const kernels::LayerKernels& kernels) {
        std::vector<std::uint32_t> entry_of(count + 1, untouched);
        std::vector<std::uint32_t> its = table;
        kernels.count_entries(records.data(), count, map, entry_of.data(), its.data());
        EXPECT_EQ(entry_of, entries);
        EXPECT_EQ(its, expected);
      });
    }
  }
}

TEST_F(RowTableKernels, CoordinatesAreCountedByLayer) {
  const kernels::PositionMap map{{1.0, -3.5, 1e6}, 1000.0, 1, 10};
  for (const std::size_t count : {0U, 1U, 2U, 3U, 5U, 8U, 64U, 301U}) {
    SCOPED_TRACE(std::to_string(count) + " coordinates");
    std::vector<double> coordinates(count);
    std::vector<std::uint64_t> expected(100, 7);
    for (double& x : coordinates) {
      x = random_.uniform(-3.5, 96.0);
      ++expected[static_cast<std::size_t>((x + 3.5) * 1000.0) / 1024];
    }
    at_each_level([&](const kernels::LayerKernels& kernels) {
      std::vector<std::uint64_t> counts(100, 7);
      kernels.count_layers(coordinates.data(), count, map, counts.data());
      EXPECT_EQ(counts, expected);
    });
  }
}

}  // namespace
}  // namespace abut::testing
