// The walk through the cells of a tile, included once for each instruction set: no include guard
// but the one that its includer sets, and nothing here but templates in the includer's namespace.
//
// For a block of a few cells of one row, the runs of neighbours are gathered once into a contiguous
// buffer, the block's own elements first; each of those then meets what stands behind it.
//
//   buffer   | block's cells, next cell | row y + 1 | rows y - 1, y, y + 1 of the layer z + 1 |
//                  ^ element p meets everything behind it
//
// Copies meet own elements only: a pair of copies is found in another tile.

/// Three cells to a block gave the least time on dense packings (docs/adr/0010).
constexpr std::int32_t cells_per_block = 3;

template <int Dim, class Block>
class TileSearch {
 public:
  TileSearch(const TileView& tile, SearchJob& job) : tile_(tile), job_(job) {}

  void search() {
    if constexpr (Dim == 2) {
      search_layer(0);
    } else {
      for (std::int32_t z = 0; z <= tile_.cells[2] + 1; ++z) search_layer(z);
    }
  }

 private:
  void search_layer(std::int32_t z) {
    const bool own_layer = Dim == 2 || is_own(z, 2);
    for (std::int32_t y = 0; y <= tile_.cells[1] + 1; ++y) {
      const std::uint32_t* row = row_of(y, z);
      const std::int32_t last = tile_.cells[0] + 1;
      if (row[0] == row[last + 1]) continue;
      if (own_layer && is_own(y, 1)) {
        meet_from_copies(row, y, z, 0, 0);
        for (std::int32_t x = 1; x < last; x += cells_per_block) {
          search_block(row, x, x + cells_per_block <= last ? x + cells_per_block : last);
        }
        meet_from_copies(row, y, z, last, last);
      } else {
        for (std::int32_t x = 0; x <= last; x += cells_per_block) {
          const std::int32_t end = x + cells_per_block - 1;
          meet_from_copies(row, y, z, x, end < last ? end : last);
        }
      }
    }
  }

  /// Cells [first, end) of an own row: with each other, the next cell, and the rows ahead.
  void search_block(const std::uint32_t* row, std::int32_t first, std::int32_t end) {
    const std::uint32_t central = row[end] - row[first];
    if (central == 0) return;
    Block block(tile_, job_);
    block.append(row[first], row[end + 1]);
    append_row(block, row + tile_.row_length(), first - 1, end);
    if constexpr (Dim == 3) {
      const std::uint32_t* above = row + tile_.layer_length();
      append_row(block, above - tile_.row_length(), first - 1, end);
      append_row(block, above, first - 1, end);
      append_row(block, above + tile_.row_length(), first - 1, end);
    }
    block.close();
    for (std::uint32_t p = 0; p < central; ++p) block.meet(block.element(p), p + 1);
    block.finish();
  }

  /// Copies in the cells [first, last]: with the own elements ahead of them.
  void meet_from_copies(const std::uint32_t* row, std::int32_t y, std::int32_t z,
                        std::int32_t first, std::int32_t last) {
    const std::uint32_t central = row[last + 1] - row[first];
    if (central == 0) return;
    Block block(tile_, job_);
    block.append(row[first], row[last + 1]);
    if ((Dim == 2 || is_own(z, 2)) && is_own(y, 1) && last == 0) append_row(block, row, 1, 1);
    const std::int32_t from = first > 1 ? first - 1 : 1;
    const std::int32_t to = last < tile_.cells[0] ? last + 1 : tile_.cells[0];
    if (from > to) return;
    if (Dim == 2 || is_own(z, 2)) append_own_row(block, y + 1, z, from, to);
    if constexpr (Dim == 3) {
      if (is_own(z + 1, 2)) {
        for (std::int32_t ahead = y - 1; ahead <= y + 1; ++ahead) {
          append_own_row(block, ahead, z + 1, from, to);
        }
      }
    }
    if (block.size() == central) return;
    block.close();
    for (std::uint32_t p = 0; p < central; ++p) block.meet(block.element(p), central);
    block.finish();
  }

  void append_own_row(Block& block, std::int32_t y, std::int32_t z, std::int32_t first,
                      std::int32_t last) {
    if (is_own(y, 1)) append_row(block, row_of(y, z), first, last);
  }

  static void append_row(Block& block, const std::uint32_t* row, std::int32_t first,
                         std::int32_t last) {
    block.append(row[first], row[last + 1]);
  }

  [[nodiscard]] bool is_own(std::int32_t index, int axis) const {
    return index >= 1 && index <= tile_.cells[axis];
  }

  [[nodiscard]] const std::uint32_t* row_of(std::int32_t y, std::int32_t z) const {
    return tile_.cell_begin + (z * (tile_.cells[1] + 2) + y) * tile_.row_length();
  }

  const TileView& tile_;
  SearchJob& job_;
};

/// Gathers the runs and lets the visitor meet them.
template <class Block>
void visit(const TileView& tile, SearchJob& job, const Visitor& visitor,
           std::span<const Run> runs) {
  Block block(tile, job);
  for (const Run& run : runs) block.append(run.begin, run.end);
  if (block.size() == 0) return;
  block.close();
  block.meet(block.element_of(visitor), 0);
  block.finish();
}
