// The runs of near elements, set up in vectors, included like simd_joined_runs-inl.hpp: the numbers
// of NearRuns.

template <int Dim>
class NearBatch {
 public:
  static constexpr std::size_t runs = NearRuns<Dim>::size;
  static constexpr std::uint32_t most = 64;

  /// The near elements among those of a row, `most` or fewer.
  HWY_INLINE NearBatch(const ThreeLayers& layers, const Run& elements)
      : table_(layers.own), begin_(elements.begin) {
    const std::uint32_t count = elements.end - elements.begin;
    for (std::uint32_t k = 0; k < count; k += lanes) set_up(layers, k, count - k);
  }

  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return size_; }
  [[nodiscard]] HWY_INLINE std::uint32_t place(std::uint32_t k) const { return begin_ + list_[k]; }

  class RunsAt {
   public:
    static constexpr std::size_t size = runs;

    HWY_INLINE RunsAt(const NearBatch& batch, std::uint32_t at) : batch_(batch), at_(at) {}
    template <std::size_t k>
    [[nodiscard]] HWY_INLINE Run run() const {
      const std::uint32_t* const first = batch_.table_ + batch_.first_[k][at_];
      return {first[0], first[batch_.columns_[k][at_]]};
    }

   private:
    const NearBatch& batch_;
    std::uint32_t at_;
  };
  [[nodiscard]] HWY_INLINE RunsAt runs_of(std::uint32_t k) const { return {*this, list_[k]}; }

 private:
  HWY_INLINE void set_up(const ThreeLayers& layers, std::uint32_t k, std::uint32_t left) {
    const std::uint32_t p = begin_ + k;
    const Floats radius = hn::LoadU(floats, layers.radius + p);
    const Floats reach = hn::Add(hn::Add(radius, radius), hn::Set(floats, layers.margin + 8.0f));
    list(k, bits_of(hn::Lt(reach, hn::Set(floats, near_reach))) & lanes_before(left));
    // That of far elements may have no whole number; their runs are not used.
    const Integers half = hn::ConvertTo(integers, hn::Min(reach, hn::Set(floats, near_reach)));
    const auto from = [&](int axis) {
      return hn::Sub(hn::LoadU(integers, layers.position[axis] + p), half);
    };
    const Integers both = hn::Add(half, half);
    const Integers along_row = from(layers.row_axis);
    const Integers first_column = hn::ShiftRightSame(along_row, layers.column_shift);
    const Integers columns =
        hn::Sub(hn::ShiftRightSame(hn::Add(along_row, both), layers.column_shift),
                hn::Sub(first_column, hn::Set(integers, 1)));
    const Integers across = from(layers.next_row_axis);
    const Integers first_row = hn::ShiftRight<cell_bits>(across);
    const auto is_one_row = hn::Eq(hn::ShiftRight<cell_bits>(hn::Add(across, both)), first_row);
    const Integers upper_columns = hn::IfThenZeroElse(is_one_row, columns);
    const Integers row = hn::Sub(first_row, hn::Set(integers, layers.first_row));
    const Integers length = hn::Set(integers, static_cast<std::int32_t>(layers.row_length));
    const Integers begin = hn::Add(
        hn::Mul(row, length),
        hn::Add(first_column, hn::Add(length, hn::Set(integers, std::int32_t{near_columns}))));
    store(0, k, begin, columns);
    store(1, k, hn::Add(begin, length), upper_columns);
    if constexpr (Dim == 2) {
      cross_strips(layers, k, row);
    } else {
      set_up_other_layer(layers, k, hn::LoadU(integers, layers.position[layers.layer_axis] + p),
                         half);
    }
  }

  HWY_INLINE void cross_strips(const ThreeLayers& layers, std::uint32_t k, Integers row) {
    const auto rows = static_cast<std::int32_t>(layers.rows);
    const std::int32_t strip = rows * static_cast<std::int32_t>(layers.row_length);
    const auto move_where = [&](std::size_t run, hn::Mask<IntegerTag> where, std::int32_t by) {
      const Integers first = hn::LoadU(integers, first_[run] + k);
      hn::StoreU(hn::Add(first, hn::IfThenElseZero(where, hn::Set(integers, by))), integers,
                 first_[run] + k);
    };
    move_where(0, hn::Lt(row, hn::Zero(integers)), layers.to_below + strip);
    move_where(1, hn::Eq(row, hn::Set(integers, rows - 1)), layers.to_next - strip);
  }

  HWY_INLINE void set_up_other_layer(const ThreeLayers& layers, std::uint32_t k,
                                     Integers across_layers, Integers half) {
    const Integers first_layer = hn::ShiftRight<cell_bits>(hn::Sub(across_layers, half));
    const Integers last_layer = hn::ShiftRight<cell_bits>(hn::Add(across_layers, half));
    const auto is_one_layer = hn::Eq(first_layer, last_layer);
    const Integers other =
        hn::IfThenElse(hn::Lt(first_layer, hn::Set(integers, layers.layer)),
                       hn::Set(integers, layers.to_below), hn::Set(integers, layers.to_next));
    for (std::size_t run = 0; run < 2; ++run) {
      store(run + 2, k, hn::Add(hn::LoadU(integers, first_[run] + k), other),
            hn::IfThenZeroElse(is_one_layer, hn::LoadU(integers, columns_[run] + k)));
    }
  }

  HWY_INLINE void store(std::size_t run, std::uint32_t k, Integers first, Integers columns) {
    hn::StoreU(first, integers, first_[run] + k);
    hn::StoreU(columns, integers, columns_[run] + k);
  }

  /// Adds the lanes of the set to the list.
  HWY_INLINE void list(std::uint32_t k, Bits set) {
    hn::StoreU(compress(numbers_from(k), set), numbers, list_ + size_);
    size_ += static_cast<std::uint32_t>(std::popcount(set));
  }

  const std::uint32_t* table_;
  std::uint32_t begin_;
  std::uint32_t size_ = 0;
  std::uint32_t list_[most + lanes];  ///< of the near ones, from the first element on
  std::int32_t first_[runs][most + lanes];
  std::int32_t columns_[runs][most + lanes];
};
