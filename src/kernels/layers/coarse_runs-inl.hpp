// The runs in which coarse elements look, included like runs_of_row-inl.hpp.
//
// A coarse element stands in no layer, and may lie anywhere. Its reach is what it needs to meet the
// largest element that stands in one.

/// Where a coarse element is along an axis, in units.
[[nodiscard]] inline double coarse_position(const FarSphere& coarse, int axis) {
  return double{coarse.beyond[axis]} + coarse.position[axis];
}

/// An axis cut into pieces 2^shift wide.
class PiecesOfAxis {
 public:
  explicit PiecesOfAxis(int shift)
      : width_(static_cast<double>(std::int64_t{1} << shift)), per_unit_(1.0 / width_) {}

  /// The pieces from number `least` to `most` that a stretch meets: from the first to the last.
  [[nodiscard]] PieceRange between(double lower, double upper, std::int64_t least,
                                   std::int64_t most) const {
    return {std::max(piece(lower, least, most), least), std::min(piece(upper, least, most), most)};
  }

  /// The square of the units from a position to the nearest one in a piece.
  [[nodiscard]] double square_to(std::int64_t piece, double position) const {
    const double lower = static_cast<double>(piece) * width_;
    const double gap = std::max({lower - position, position - (lower + width_), 0.0});
    return gap * gap;
  }

 private:
  /// Before the clamp a number may be larger than any whole one.
  [[nodiscard]] std::int64_t piece(double position, std::int64_t least, std::int64_t most) const {
    const double number = std::clamp(position * per_unit_, static_cast<double>(least - 1),
                                     static_cast<double>(most + 1));
    // Rounded downwards, which is rounded towards 0 where numbers are not below 0.
    return static_cast<std::int64_t>(number - static_cast<double>(least - 1)) + (least - 1);
  }

  double width_;
  double per_unit_;
};

/// The first entry of each row of the own layer's table whose columns are counted from 0, from the
/// row with this number on.
[[nodiscard]] inline const std::uint32_t* row_of_columns(const ThreeLayers& layers,
                                                         std::int64_t row) {
  const std::uint32_t columns_in_reach = layers.end_of_run / 2;
  return layers.own + (row - layers.first_row + 1) * std::int64_t{layers.row_length} +
         columns_in_reach;
}

/// The elements of some columns of a row.
[[nodiscard]] inline Run run_of(const std::uint32_t* row, const PieceRange& columns) {
  return {row[columns.first], row[columns.last + 1]};
}

/// Calls test(run) for each run of the own layer that the ball of a coarse sphere cuts.
template <int Dim, class Test>
void for_each_run_in_coarse_ball(const ThreeLayers& layers, const FarSphere& coarse,
                                 const Test& test) {
  const double sum = double{coarse.radius} + layers.largest_size;
  const double reach = (sum + (double{layers.margin} + 8.0)) * room;
  const PiecesOfAxis cells(layers.cell_shift);
  const PiecesOfAxis columns(layers.column_shift);
  double square = reach * reach;
  if constexpr (Dim == 3) {
    square -= cells.square_to(layers.layer, coarse_position(coarse, layers.layer_axis));
  }
  if (!(square >= 0.0)) return;
  const double across = coarse_position(coarse, layers.next_row_axis);
  const double along = coarse_position(coarse, layers.row_axis);
  const double in_layer = std::sqrt(square);
  const std::int64_t first_row = layers.first_row;
  const PieceRange rows =
      cells.between(across - in_layer, across + in_layer, first_row, first_row + layers.rows - 1);
  for (std::int64_t row = rows.first; row <= rows.last; ++row) {
    const double in_row = std::sqrt(std::max(square - cells.square_to(row, across), 0.0));
    const PieceRange cut =
        columns.between(along - in_row, along + in_row, 0, std::int64_t{layers.columns} - 1);
    if (cut.first <= cut.last) test(run_of(row_of_columns(layers, row), cut));
  }
}

/// The same of a coarse box. Others that it meets begin below its lower corner by no more than the
/// largest one is wide, and above it by no more than it is wide itself.
template <int Dim, class Test>
void for_each_run_beside_coarse_box(const ThreeLayers& layers, const FarSphere& coarse,
                                    const Test& test) {
  const double margin = double{layers.margin} + 8.0;
  const double below = (layers.largest_size + margin) * room;
  const auto pieces = [&](int axis, int shift, std::int64_t least, std::int64_t most) {
    const double above = (coarse.width[axis] + margin) * room;
    const double position = coarse_position(coarse, axis);
    // The position is rounded, too.
    const double rounding = std::fabs(position) * (room - 1.0);
    return PiecesOfAxis(shift).between(position - below - rounding, position + above + rounding,
                                       least, most);
  };
  if constexpr (Dim == 3) {
    const PieceRange layer =
        pieces(layers.layer_axis, layers.cell_shift, layers.layer, layers.layer);
    if (layer.first > layer.last) return;
  }
  const std::int64_t first_row = layers.first_row;
  const PieceRange rows =
      pieces(layers.next_row_axis, layers.cell_shift, first_row, first_row + layers.rows - 1);
  const PieceRange cut =
      pieces(layers.row_axis, layers.column_shift, 0, std::int64_t{layers.columns} - 1);
  if (cut.first > cut.last) return;
  for (std::int64_t row = rows.first; row <= rows.last; ++row) {
    test(run_of(row_of_columns(layers, row), cut));
  }
}

/// Calls test(run) for each run of the own layer in which a coarse element looks.
template <int Dim, class Test>
void for_each_run_of_coarse(const ThreeLayers& layers, const FarSphere& coarse, const Test& test) {
  if (layers.shape == ElementShape::boxes) {
    return for_each_run_beside_coarse_box<Dim>(layers, coarse, test);
  }
  for_each_run_in_coarse_ball<Dim>(layers, coarse, test);
}
