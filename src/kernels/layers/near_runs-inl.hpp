// The rows in which a near element looks, included like runs_of_row-inl.hpp.
//
// Its own reach is less than half of a cell, so that it lies in no more than two rows and two
// layers. An element of row y, nearer to row y - 1 than to row y + 1, of a layer nearer to the one
// below, has the runs
//
//   own layer      | row y - 1: columns in reach | row y: the same |
//   layer below    | row y - 1: columns in reach | row y: the same |
//
// in 2D the first two. What is not in reach is an empty run. Runs are kept as places in the tables
// that begin with that of the own layer: the first column, and how many there are.

template <int Dim>
struct NearRuns {
  static constexpr std::size_t size = Dim == 2 ? 2 : 4;

  NearRuns(const ThreeLayers& layers, std::uint32_t p, std::int32_t reach) {
    const auto length = static_cast<std::int32_t>(layers.row_length);
    const std::int32_t along_row = layers.position[layers.row_axis][p];
    const std::int32_t first_column = (along_row - reach) >> layers.column_shift;
    const std::int32_t last_column = (along_row + reach) >> layers.column_shift;
    const std::int32_t across = layers.position[layers.next_row_axis][p];
    const std::int32_t first_row = (across - reach) >> cell_bits;
    const bool has_two_rows = (across + reach) >> cell_bits != first_row;
    const std::int32_t row = first_row - layers.first_row;  // from -1 on
    const std::int32_t begin = (row + 1) * length + first_column + std::int32_t{near_columns};
    columns[0] = last_column + 1 - first_column;
    columns[1] = has_two_rows ? columns[0] : 0;
    first[0] = begin;
    first[1] = begin + length;
    if constexpr (Dim == 2) {
      const auto rows = static_cast<std::int32_t>(layers.rows);
      if (row < 0) first[0] += layers.to_below + rows * length;
      if (row + 1 == rows) first[1] += layers.to_next - rows * length;
    } else {
      const std::int32_t across_layers = layers.position[layers.layer_axis][p];
      const std::int32_t first_layer = (across_layers - reach) >> cell_bits;
      const bool has_two_layers = (across_layers + reach) >> cell_bits != first_layer;
      first[2] = begin + (first_layer < layers.layer ? layers.to_below : layers.to_next);
      first[3] = first[2] + length;
      columns[2] = has_two_layers ? columns[0] : 0;
      columns[3] = has_two_layers ? columns[1] : 0;
    }
  }

  std::int32_t first[size];
  std::int32_t columns[size];
};
