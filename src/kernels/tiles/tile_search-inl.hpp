// The walk through the elements of a tile, included once for each instruction set: no include guard
// but the one that its includer sets, and nothing here but templates in the includer's namespace.
//
// An element meets the rest of its own cell and the cells ahead of it, five contiguous runs:
//
//   layer z      | row y:  own cell behind the element, cell x + 1 | row y + 1:  x - 1 .. x + 1 |
//   layer z + 1  | row y - 1:  x - 1 .. x + 1 | row y:  x - 1 .. x + 1 | row y + 1:  x - 1 .. x + 1
//   |
//
// Where runs are longer than a vector, how many vectors each takes could not be foreseen. There the
// runs of a block of cells are gathered into one, for all elements of the block.
//
// Where cells are much wider than the reach, an element lies near few of the cells around its own,
// and only those are looked at.
//
// Copies meet own elements only: a pair of copies is found in another tile.

/// Rows with more elements in a cell, on average, are searched in blocks: fewer cells gather more
/// often, more test more. docs/adr/0010 has the measurements.
constexpr std::uint32_t crowded_row = 2;
constexpr std::int32_t cells_per_block = 3;

/// Rows with more than that have blocks of one cell.
constexpr std::uint32_t crowded_cell = 5;

/// The part of the runs beyond its own row that an element lies near, on average, up to which it
/// pays to ask which: from 0.4 on it costs more than it saves.
constexpr float few_runs = 0.25f;

template <int Dim, class PairTester>
class TileSearch {
 public:
  TileSearch(const TileView& tile, SearchJob& job)
      : tile_(tile),
        row_length_(tile.row_length()),
        layer_length_(tile.layer_length()),
        is_wide_(has_wide_cells(tile, job)),
        tester_(tile, job) {}

  void search(const Layers& layers) {
    for (std::int32_t layer = layers.begin; layer < layers.end; ++layer) {
      if constexpr (Dim == 2) {
        search_row(layer, 0);
      } else {
        for (std::int32_t y = 0; y <= tile_.cells[1] + 1; ++y) search_row(y, layer);
      }
    }
    tester_.finish();
  }

 private:
  static constexpr std::size_t run_count = Dim == 2 ? 2 : 5;

  /// Tells whether elements lie near few of the rows around their own, on average.
  static bool has_wide_cells(const TileView& tile, const SearchJob& job) {
    if (tile.shape == ElementShape::boxes) return false;
    float near[3];
    for (int axis = 0; axis < Dim; ++axis) {
      const float reach = 2.0f * tile.common_radius + job.margin + job.slack;
      const float cells = reach * tile.per_unit[axis];
      near[axis] = cells < 1.0f ? cells : 1.0f;
    }
    float runs = near[1];
    if constexpr (Dim == 3) runs += near[2] * (1.0f + 2.0f * near[1]);
    return runs <= few_runs * static_cast<float>(run_count - 1);
  }

  /// The step from a cell to the cell above it in the row of run k.
  [[nodiscard]] static constexpr std::ptrdiff_t step_to(std::size_t k, std::ptrdiff_t row,
                                                        std::ptrdiff_t layer) {
    if (k < 2) return k == 0 ? 0 : row;
    return layer + (static_cast<std::ptrdiff_t>(k) - 3) * row;
  }

  /// The runs of one element, each read when it is asked for.
  class Ahead {
   public:
    /// True: behind a run lies padding, or an element that is a cell or more apart.
    static constexpr bool harmless_beyond = true;

    Ahead(std::uint32_t p, const std::uint32_t* cell, std::ptrdiff_t row, std::ptrdiff_t layer)
        : element_(p), cell_(cell), row_(row), layer_(layer) {}

    [[nodiscard]] static constexpr std::size_t size() { return run_count; }

    [[nodiscard]] Run operator[](std::size_t k) const {
      if (k == 0) return {element_ + 1, cell_[2]};
      const std::uint32_t* const ahead = cell_ + step_to(k, row_, layer_);
      return {ahead[-1], ahead[2]};
    }

   private:
    std::uint32_t element_;
    const std::uint32_t* cell_;
    std::ptrdiff_t row_;
    std::ptrdiff_t layer_;
  };

  /// Rows of own elements that a row's elements meet, one for each run; null where there is none.
  struct RowsAhead {
    const std::uint32_t* row[run_count];
  };

  /// The runs of a copy in cell x of its row: own elements only.
  class AheadOfCopy {
   public:
    /// Lanes behind the end of a run may hold other copies, which must not be found.
    static constexpr bool harmless_beyond = false;

    AheadOfCopy(const RowsAhead& rows, std::int32_t x, std::int32_t last_own)
        : rows_(rows), x_(x), first_(x > 1 ? x - 1 : 1), last_(x < last_own ? x + 1 : last_own) {}

    [[nodiscard]] static constexpr std::size_t size() { return run_count; }

    [[nodiscard]] Run operator[](std::size_t k) const {
      const std::uint32_t* const row = rows_.row[k];
      if (row == nullptr || (k == 0 && x_ != 0)) return {0, 0};
      return {row[first_], row[k == 0 ? 2 : last_ + 1]};
    }

   private:
    RowsAhead rows_;
    std::int32_t x_;
    std::int32_t first_;
    std::int32_t last_;
  };

  void search_row(std::int32_t y, std::int32_t z) {
    const std::uint32_t* row = entry_of(y, z);
    const std::int32_t last = tile_.cells[0] + 1;
    if (row[0] == row[last + 1]) return;
    const RowsAhead ahead = rows_ahead(y, z);
    if (ahead.row[0] == nullptr) return test_from_halo(row, 0, last, ahead);
    test_from_halo(row, 0, 0, ahead);
    if (const std::uint32_t most = most_in_row_ahead(row); is_crowded(most, crowded_row)) {
      test_in_blocks(row, is_crowded(most, crowded_cell) ? 1 : cells_per_block);
    } else if (is_wide_) {
      test_nearby(row, y, z);
    } else {
      test_directly(row);
    }
    test_from_halo(row, last, last, ahead);
    tester_.take_now_and_then();
  }

  /// Tests all own elements of the row in one loop: cells have few, and how many cannot be
  /// foreseen.
  void test_directly(const std::uint32_t* row) {
    tester_.test_all(row[1], row[tile_.cells[0] + 1],
                     [cell = tile_.cell, begin = tile_.cell_begin, to_row = row_length_,
                      to_layer = layer_length_](std::uint32_t p) {
                       return Ahead(p, begin + cell[p], to_row, to_layer);
                     });
  }

  /// Tests all own elements of the row, each with the cells that it lies near.
  void test_nearby(const std::uint32_t* row, std::int32_t y, std::int32_t z) {
    RowOfCells<run_count> place{row, static_cast<std::uint32_t>(row - tile_.cell_begin), {}, {}};
    for (std::size_t k = 0; k < run_count; ++k) {
      place.step[k] = step_to(k, row_length_, layer_length_);
    }
    place.index[1] = static_cast<float>(y);
    place.index[2] = static_cast<float>(z);
    tester_.test_nearby(row[1], row[tile_.cells[0] + 1], place);
  }

  /// Elements in the fullest of the rows that the row's elements meet.
  [[nodiscard]] std::uint32_t most_in_row_ahead(const std::uint32_t* row) const {
    std::uint32_t most = 0;
    for (std::size_t k = 0; k < run_count; ++k) {
      const std::uint32_t* const other = row + step_to(k, row_length_, layer_length_);
      most = std::max(most, other[tile_.cells[0] + 2] - other[0]);
    }
    return most;
  }

  /// Tells whether so many elements of a row are more than `limit` for each cell.
  [[nodiscard]] bool is_crowded(std::uint32_t elements, std::uint32_t limit) const {
    return elements > limit * static_cast<std::uint32_t>(tile_.cells[0] + 2);
  }

  void test_in_blocks(const std::uint32_t* row, std::int32_t width) {
    const std::int32_t last = tile_.cells[0] + 1;
    for (std::int32_t x = 1; x < last; x += width) {
      const std::int32_t end = x + width < last ? x + width : last;
      if (row[x] == row[end]) continue;
      Run runs[run_count] = {{row[x], row[end + 1]}};
      for (std::size_t k = 1; k < run_count; ++k) {
        const std::uint32_t* const ahead = row + step_to(k, row_length_, layer_length_);
        runs[k] = {ahead[x - 1], ahead[end + 1]};
      }
      tester_.test_block(row[end] - row[x], runs);
    }
  }

  /// Copies in the cells [first, last] of a row.
  void test_from_halo(const std::uint32_t* row, std::int32_t first, std::int32_t last,
                      const RowsAhead& ahead) {
    if (row[first] == row[last + 1]) return;
    if (std::none_of(ahead.row, ahead.row + run_count, [](auto* other) { return other; })) return;
    tester_.test_all(
        row[first], row[last + 1],
        [&ahead, cell = tile_.cell, last_own = tile_.cells[0],
         first_of_row = static_cast<std::int32_t>(row - tile_.cell_begin)](std::uint32_t p) {
          const auto x = static_cast<std::int32_t>(cell[p]) - first_of_row;
          return AheadOfCopy(ahead, x, last_own);
        });
  }

  [[nodiscard]] RowsAhead rows_ahead(std::int32_t y, std::int32_t z) const {
    RowsAhead ahead{own_row(y, z), own_row(y + 1, z)};
    if constexpr (Dim == 3) {
      for (std::int32_t k = 0; k < 3; ++k) ahead.row[2 + k] = own_row(y - 1 + k, z + 1);
    }
    return ahead;
  }

  [[nodiscard]] const std::uint32_t* own_row(std::int32_t y, std::int32_t z) const {
    return is_own(y, 1) && is_own(z, 2) ? entry_of(y, z) : nullptr;
  }

  /// Tells whether a cell is the tile's own; in 2D the only layer is 0.
  [[nodiscard]] bool is_own(std::int32_t index, int axis) const {
    if (Dim == 2 && axis == 2) return true;
    return index >= 1 && index <= tile_.cells[axis];
  }

  [[nodiscard]] const std::uint32_t* entry_of(std::int32_t y, std::int32_t z) const {
    return tile_.cell_begin + (z * (tile_.cells[1] + 2) + y) * row_length_;
  }

  const TileView& tile_;
  std::ptrdiff_t row_length_;
  std::ptrdiff_t layer_length_;
  bool is_wide_;
  PairTester tester_;
};

template <class PairTester>
void test_coarse(const TileView& tile, SearchJob& job, const CoarseElement& coarse,
                 std::span<const Run> runs) {
  PairTester tester(tile, job);
  tester.test(coarse, runs);
  tester.finish();
}
