#include "engine/tiles/sorted_tile.hpp"

#include "engine/random_spheres.hpp"
#include "support/nobody_asked.hpp"
#include "support/rows_variants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace abut::testing {
namespace {

template <class Dimension>
class SortedTileOf : public ::testing::Test {
 protected:
  static constexpr int dim = Dimension::value;

  /// Elements in a tile of sides 1 x 0.75 x 0.5, then copies up to a cell outside it; some a last
  /// place from its faces, where single precision no longer says which side they are on.
  void make(std::uint64_t seed, std::size_t own_count, std::size_t copy_count) {
    Random random(seed);
    own = own_count;
    records.clear();
    radii.clear();
    const std::array<float, 3> sides{1.0f, 0.75f, 0.5f};
    for (std::size_t k = 0; k < own_count + copy_count; ++k) {
      engine::Record<dim> record{};
      for (std::size_t axis = 0; axis < dim; ++axis) {
        record.center[axis] = sides[axis] * static_cast<float>(random.uniform());
        if (random.below(8) == 0) record.center[axis] = random.below(2) == 0 ? 0.0f : sides[axis];
      }
      if (k >= own_count) {
        const std::size_t axis = random.below(dim);
        const auto beyond =
            static_cast<float>(random.below(4) == 0 ? 0.0 : 0.05 * random.uniform());
        record.center[axis] = random.below(2) == 0 ? -beyond : sides[axis] + beyond;
      }
      radii.push_back(static_cast<float>(random.uniform()));
      record.number = static_cast<std::uint32_t>(1000 + k);
      records.push_back(record);
    }
    engine::TileGrid<dim> grid;
    grid.cell_size = 0.05;
    for (std::size_t axis = 0; axis < dim; ++axis) grid.size[axis] = sides[axis];
    cells = engine::choose_tile_cells(grid, 1.0, 100000);
  }

  /// With something behind the last record, as vectors may read there.
  [[nodiscard]] std::span<const engine::Record<dim>> all() {
    records.reserve(records.size() + 1);
    return records;
  }

  void sort(engine::SortedTile<dim>& tile, const engine::RecordSizes& sizes, Simd level) {
    const auto kernels = kernels::element_kernels(level);
    abut::testing::NobodyAsked nobody;
    tile.count(all(), own, cells, kernels, nobody.work);
    tile.sort(all(), sizes, kernels, nobody.work);
  }

  std::vector<engine::Record<dim>> records;
  std::vector<float> radii;
  std::size_t own = 0;
  engine::TileCells<dim> cells;
  base::MemoryMeter memory;
};

TYPED_TEST_SUITE(SortedTileOf, Dimensions);

/// Whether a cell with that number is in the frame.
template <int Dim>
bool in_frame(const kernels::TileView& view, std::int32_t cell,
              std::array<std::int32_t, 3>& index) {
  bool frame = false;
  const std::array<std::int32_t, 3> lengths{view.row_length(), view.cells[1] + 2,
                                            view.cells[2] + 2};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    index[axis] = cell % lengths[axis];
    cell /= lengths[axis];
    frame = frame || index[axis] == 0 || index[axis] == view.cells[axis] + 1;
  }
  return frame;
}

template <int Dim>
std::int32_t cells_in(const kernels::TileView& view) {
  return Dim == 2 ? view.layer_length() : view.layer_length() * (view.cells[2] + 2);
}

/// Own elements are in own cells, copies in the frame, each once and near where it lies; rows end
/// with padding.
TYPED_TEST(SortedTileOf, CellsHoldOwnElementsAndTheFrameCopies) {
  engine::SortedTile<TypeParam::value> tile(this->memory);
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    this->make(seed, 700 * seed, 300);
    this->sort(tile, {kernels::ElementShape::spheres, this->radii, 0.0f}, Simd::scalar);
    const kernels::TileView& view = tile.view();
    const std::int32_t total = cells_in<TypeParam::value>(view);
    const std::int32_t rows = total / view.row_length();
    ASSERT_EQ(view.cell_begin[0], 0U);
    ASSERT_EQ(view.cell_begin[total],
              this->records.size() + static_cast<std::size_t>(rows) * kernels::row_padding);
    std::vector<int> seen(this->records.size());
    std::uint64_t crowding = 0;
    for (std::int32_t cell = 0; cell < total; ++cell) {
      std::array<std::int32_t, 3> index{};
      const bool frame = in_frame<TypeParam::value>(view, cell, index);
      ASSERT_LE(view.cell_begin[cell], view.cell_begin[cell + 1]);
      const std::uint64_t count = view.cell_begin[cell + 1] - view.cell_begin[cell];
      const bool padding = index[0] == view.cells[0] + 2;
      if (padding) {
        ASSERT_EQ(count, kernels::row_padding);
      } else {
        crowding += count * count;
      }
      for (std::uint32_t k = view.cell_begin[cell]; k < view.cell_begin[cell + 1]; ++k) {
        if (padding) {
          ASSERT_EQ(view.center[0][k], kernels::far_away);
          continue;
        }
        const std::size_t r = view.number[k] - 1000;
        ++seen.at(r);
        ASSERT_EQ(view.cell[k], static_cast<std::uint32_t>(cell));
        ASSERT_EQ(frame, r >= this->own) << "record " << r;
        ASSERT_EQ(view.size[0][k], this->radii[r]);
        for (std::size_t axis = 0; axis < TypeParam::value; ++axis) {
          ASSERT_EQ(view.center[axis][k], this->records[r].center[axis]);
          const double q = view.center[axis][k] * this->cells.per_unit[axis] + 1.0;
          ASSERT_LE(index[axis], q + 1e-5);
          ASSERT_GE(index[axis] + 1, q - 1e-5);
        }
      }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
    EXPECT_EQ(tile.squared_occupancy(), crowding);
    EXPECT_EQ(tile.size(), this->records.size());
    EXPECT_EQ(view.shape, kernels::ElementShape::spheres);
  }
}

/// Records of a cell keep their order: pairs come in the same order whatever came before.
TYPED_TEST(SortedTileOf, TheSortIsStable) {
  engine::SortedTile<TypeParam::value> tile(this->memory);
  this->make(9, 2000, 200);
  this->sort(tile, {kernels::ElementShape::equal_spheres, {}, 0.25f}, Simd::scalar);
  const kernels::TileView& view = tile.view();
  for (std::int32_t cell = 0; cell < cells_in<TypeParam::value>(view); ++cell) {
    if (cell % view.row_length() == view.cells[0] + 2) continue;
    EXPECT_TRUE(std::is_sorted(view.number + view.cell_begin[cell],
                               view.number + view.cell_begin[cell + 1]));
  }
  EXPECT_EQ(view.common_radius, 0.25f);
}

TYPED_TEST(SortedTileOf, VectorsSortAlike) {
  engine::SortedTile<TypeParam::value> plain(this->memory);
  this->make(10, 3001, 203);
  this->sort(plain, {kernels::ElementShape::spheres, this->radii, 0.0f}, Simd::scalar);
  const kernels::TileView& expected = plain.view();
  const std::int32_t total = cells_in<TypeParam::value>(expected);
  for (const Simd level : testing::simd_levels_here()) {
    SCOPED_TRACE(std::string(name_of(level)));
    engine::SortedTile<TypeParam::value> tile(this->memory);
    this->sort(tile, {kernels::ElementShape::spheres, this->radii, 0.0f}, level);
    const kernels::TileView& view = tile.view();
    ASSERT_TRUE(std::equal(view.cell_begin, view.cell_begin + total + 1, expected.cell_begin));
    for (std::int32_t cell = 0; cell < total; ++cell) {
      const bool padding = cell % view.row_length() == view.cells[0] + 2;
      for (std::uint32_t k = view.cell_begin[cell]; k < view.cell_begin[cell + 1]; ++k) {
        ASSERT_EQ(view.center[0][k], expected.center[0][k]);
        if (padding) continue;
        ASSERT_EQ(view.number[k], expected.number[k]);
        ASSERT_EQ(view.size[0][k], expected.size[0][k]);
        for (std::size_t axis = 1; axis < TypeParam::value; ++axis) {
          ASSERT_EQ(view.center[axis][k], expected.center[axis][k]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace abut::testing
