// The walk through the rows of a layer, included once for each instruction set: no include guard
// but the one that its includer sets, and nothing here but templates in the includer's namespace.
//
// An element meets what follows it in its own row, and four more runs (in 2D one):
//
//   own layer    | row y: behind the element .. column c + K | row y + 1: c - K .. c + K |
//   next layer   | row y - 1: c - K .. c + K | row y: the same | row y + 1: the same |

/// The elements of one row.
class ElementsOfRow {
 public:
  ElementsOfRow(const LayerPair& layers, std::uint32_t row)
      : table_(layers.own + std::size_t{row} * layers.row_length), length_(layers.row_length) {}

  [[nodiscard]] Run elements() const { return {table_[0], table_[length_ - 1]}; }

 private:
  const std::uint32_t* table_;
  std::size_t length_;
};

/// The tables of the rows that the elements of one row meet.
template <int Dim>
class RunsOfRow {
 public:
  RunsOfRow(const LayerPair& layers, std::uint32_t row)
      : own_(layers.own + std::size_t{row} * layers.row_length),
        end_(layers.end_of_run),
        length_(layers.row_length) {
    if constexpr (Dim == 2) {
      // The last row of a strip meets the first one of the next.
      next_ = row < layers.rows ? own_ + length_ : layers.next + length_;
    } else {
      next_ = layers.next + std::size_t{row} * length_;
    }
  }

  static constexpr std::size_t size = Dim == 2 ? 2 : 5;

  /// Places of the row's elements.
  [[nodiscard]] Run elements() const { return {own_[0], own_[length_ - 1]}; }

  /// Place of the first element in a column or behind it.
  [[nodiscard]] std::uint32_t begin_of(std::uint32_t column) const {
    return own_[column + (end_ - 1) / 2];
  }

  /// Run k of the element at place p in that column.
  template <std::size_t k>
  [[nodiscard]] Run run(std::uint32_t p, std::uint32_t column) const {
    if constexpr (k == 0) return {p + 1, own_[column + end_]};
    const std::uint32_t* const row = row_of_run<k>() + column;
    return {row[0], row[end_]};
  }

  [[nodiscard]] Run run(std::size_t k, std::uint32_t p, std::uint32_t column) const {
    switch (k) {
      case 0:
        return run<0>(p, column);
      case 1:
        return run<1>(p, column);
      case 2:
        return run<2>(p, column);
      case 3:
        return run<3>(p, column);
      default:
        return run<4>(p, column);
    }
  }

 private:
  template <std::size_t k>
  [[nodiscard]] const std::uint32_t* row_of_run() const {
    if constexpr (Dim == 2) return next_;
    if constexpr (k == 1) return own_ + length_;
    return next_ + (static_cast<std::ptrdiff_t>(k) - 3) * static_cast<std::ptrdiff_t>(length_);
  }

  const std::uint32_t* own_;
  const std::uint32_t* next_;
  std::size_t end_;
  std::size_t length_;
};
