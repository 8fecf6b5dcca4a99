// The runs in which elements that are not near look, included like runs_of_row-inl.hpp.

/// Reaches of far elements are widened by this factor, more than what rounds them.
constexpr double room = 1.0 + 0x1p-18;

/// The pieces 2^shift wide, from number `least` to `most`, that a stretch around a position cuts:
/// from the first to the last.
struct PieceRange {
  PieceRange(std::int64_t first_piece, std::int64_t last_piece)
      : first(first_piece), last(last_piece) {}

  PieceRange(std::int32_t position, double reach, int shift, std::int64_t least, std::int64_t most)
      : PieceRange(position, reach, reach, shift, least, most) {}

  /// Of a stretch that goes as far as `below` downwards and as far as `above` upwards.
  PieceRange(std::int32_t position, double below, double above, int shift, std::int64_t least,
             std::int64_t most)
      : first(std::max((position - whole(below)) >> shift, least)),
        last(std::min((position + whole(above)) >> shift, most)) {}

  [[nodiscard]] static std::int64_t whole(double reach) {
    constexpr double farthest = 0x1p32;
    return static_cast<std::int64_t>(std::min(reach, farthest)) + 1;
  }

  std::int64_t first;
  std::int64_t last;
};

/// The square of the units from a position to the nearest one in a cell.
[[nodiscard]] inline double square_to_cell(std::int32_t position, std::int64_t cell) {
  const std::int64_t lower = cell << cell_bits;
  const std::int64_t upper = lower + (std::int64_t{1} << cell_bits) - 1;
  const auto gap =
      static_cast<double>(std::max({lower - position, position - upper, std::int64_t{0}}));
  return gap * gap;
}

/// Calls test(run) for each run of the own layer that the ball of a far sphere cuts. Where the
/// ball cuts few rows, all runs are as long as the longest.
template <int Dim, class Test>
void for_each_run_in_ball(const ThreeLayers& layers, const FarSphere& far, const Test& test) {
  constexpr std::int64_t few_rows = 4;
  const double reach = double{own_reach(far.radius, layers.margin)} * room;
  double square = reach * reach;
  if constexpr (Dim == 3) square -= square_to_cell(far.position[layers.layer_axis], layers.layer);
  if (!(square >= 0.0)) return;
  const std::int64_t first_row = layers.first_row;
  const double in_layer = std::sqrt(square);
  const PieceRange rows(far.position[layers.next_row_axis], in_layer, cell_bits, first_row,
                        first_row + layers.rows - 1);
  const auto columns_within = [&](double in_row) {
    return PieceRange(far.position[layers.row_axis], in_row, layers.column_shift, 0,
                      std::int64_t{layers.columns} - 1);
  };
  const bool has_few_rows = rows.last - rows.first < few_rows;
  PieceRange columns = columns_within(in_layer);
  const std::uint32_t* of_row =
      layers.own + (rows.first - first_row + 1) * std::int64_t{layers.row_length} + near_columns;
  for (std::int64_t row = rows.first; row <= rows.last; ++row, of_row += layers.row_length) {
    if (!has_few_rows) {
      const double left = square - square_to_cell(far.position[layers.next_row_axis], row);
      columns = columns_within(std::sqrt(std::max(left, 0.0)));
    }
    if (columns.first > columns.last) continue;
    test(Run{of_row[columns.first], of_row[columns.last + 1]});
  }
}

/// The same of a far box. Smaller ones lie as far below its lower corner as it is wide itself on
/// any axis, and above as far as it goes on that one.
template <int Dim, class Test>
void for_each_run_beside_box(const ThreeLayers& layers, const FarSphere& far, const Test& test) {
  const double below = double{own_reach(far.radius, layers.margin)} * room;
  const auto pieces = [&](int axis, int shift, std::int64_t least, std::int64_t most) {
    const double above = double{own_reach(0.5f * far.width[axis], layers.margin)} * room;
    return PieceRange(far.position[axis], below, above, shift, least, most);
  };
  if constexpr (Dim == 3) {
    const PieceRange layer = pieces(layers.layer_axis, cell_bits, layers.layer, layers.layer);
    if (layer.first > layer.last) return;
  }
  const std::int64_t first_row = layers.first_row;
  const PieceRange rows =
      pieces(layers.next_row_axis, cell_bits, first_row, first_row + layers.rows - 1);
  const PieceRange columns =
      pieces(layers.row_axis, layers.column_shift, 0, std::int64_t{layers.columns} - 1);
  if (columns.first > columns.last) return;
  const std::uint32_t* of_row =
      layers.own + (rows.first - first_row + 1) * std::int64_t{layers.row_length} + near_columns;
  for (std::int64_t row = rows.first; row <= rows.last; ++row, of_row += layers.row_length) {
    test(Run{of_row[columns.first], of_row[columns.last + 1]});
  }
}

/// Calls test(run) for each run of the own layer in which a far element looks.
template <int Dim, class Test>
void for_each_run(const ThreeLayers& layers, const FarSphere& far, const Test& test) {
  if (layers.shape == ElementShape::boxes) return for_each_run_beside_box<Dim>(layers, far, test);
  for_each_run_in_ball<Dim>(layers, far, test);
}

/// The element at place p.
[[nodiscard]] inline FarSphere element_at(const ThreeLayers& layers, std::uint32_t p) {
  const std::int32_t position[3] = {layers.position[0][p], layers.position[1][p],
                                    layers.position[2][p]};
  if (layers.shape == ElementShape::boxes) {
    float width[3]{};
    for (int axis = 0; axis < 3 && layers.width[axis] != nullptr; ++axis) {
      width[axis] = layers.width[axis][p];
    }
    return far_box(position, layers.number[p], layers.radius[p], width, layers.margin);
  }
  return far_sphere(position, layers.number[p], layers.radius[p], layers.margin);
}

/// The numbers of the pieces 2^shift wide that a middle element's reach cuts.
struct NearPieces {
  NearPieces(std::int32_t position, std::int32_t reach, int shift)
      : first((position - reach) >> shift), last((position + reach) >> shift) {}

  std::int32_t first;
  std::int32_t last;
};

/// The most runs of a middle element: its reach is below a cell, so that it cuts up to three cells
/// along each axis.
template <int Dim>
inline constexpr std::uint32_t most_runs_around = Dim == 2 ? 3 : 9;

/// The same for a middle element of the own layer, and all three layers: of adjacent rows in
/// adjacent layers, each as long as the element's own reach.
template <int Dim, class Test>
void for_each_run_around(const ThreeLayers& layers, const FarSphere& element, const Test& test) {
  const auto reach = static_cast<std::int32_t>(own_reach(element.radius, layers.margin));
  const NearPieces columns(element.position[layers.row_axis], reach, layers.column_shift);
  const std::int32_t begin = std::max(columns.first, 0) + std::int32_t{near_columns};
  const std::int32_t end = std::min(columns.last, static_cast<std::int32_t>(layers.columns) - 1) +
                           1 + std::int32_t{near_columns};
  const auto length = static_cast<std::int32_t>(layers.row_length);
  // Rows of a table are counted from the empty one on.
  const auto test_row = [&](std::int32_t table, std::int32_t row) {
    const std::uint32_t* const of_row = layers.own + (table + row * length);
    test(Run{of_row[begin], of_row[end]});
  };
  const NearPieces rows(element.position[layers.next_row_axis], reach, cell_bits);
  const std::int32_t first_row = rows.first - layers.first_row + 1;
  const std::int32_t last_row = rows.last - layers.first_row + 1;
  if constexpr (Dim == 2) {
    const auto in_strip = static_cast<std::int32_t>(layers.rows);
    for (std::int32_t row = first_row; row <= last_row; ++row) {
      if (row < 1) {
        test_row(layers.to_below, row + in_strip);
      } else if (row > in_strip) {
        test_row(layers.to_next, row - in_strip);
      } else {
        test_row(0, row);
      }
    }
  } else {
    const NearPieces cut(element.position[layers.layer_axis], reach, cell_bits);
    for (std::int32_t layer = cut.first; layer <= cut.last; ++layer) {
      const std::int32_t table = layer == layers.layer  ? 0
                                 : layer < layers.layer ? layers.to_below
                                                        : layers.to_next;
      for (std::int32_t row = first_row; row <= last_row; ++row) test_row(table, row);
    }
  }
}
