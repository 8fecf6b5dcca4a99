// Which cells elements lie near, in vectors, included like simd_pair_tester-inl.hpp.

/// Elements of a row, a batch of them, by the runs that may hold partners:
///
///   run   0          1      2             3      4
///   near  (always)   y + 1  z + 1, y - 1  z + 1  z + 1, y + 1
template <int Dim, ElementShape Shape, std::size_t Runs>
class SimdNearby {
 public:
  static constexpr std::uint32_t batch_size = 64;

  HWY_INLINE SimdNearby(const TileView& tile, const SearchJob& job)
      : tile_(tile), largest_(tile.common_radius + job.margin + job.slack) {}

  /// Elements [first, last), at most a batch.
  HWY_INLINE void list(std::uint32_t first, std::uint32_t last, const RowOfCells<Runs>& row) {
    for (std::size_t k = 1; k < Runs; ++k) size_[k] = 0;
    first_ = first;
    for (std::uint32_t p = first; p < last; p += lanes) list_vector(p, last, row);
  }

  [[nodiscard]] HWY_INLINE std::span<const std::uint32_t> near_run(std::size_t k) const {
    return {list_[k], size_[k]};
  }

  /// 1 for each element of the batch that lies near the cell before (after) its own, 0 for others.
  [[nodiscard]] HWY_INLINE const std::uint32_t* before() const { return before_; }
  [[nodiscard]] HWY_INLINE const std::uint32_t* after() const { return after_; }

 private:
  HWY_INLINE void list_vector(std::uint32_t p, std::uint32_t last, const RowOfCells<Runs>& row) {
    const hn::RebindToSigned<NumberTag> integers;
    const Bits within = last - p < lanes ? (1u << (last - p)) - 1 : all_lanes;
    Floats reach = hn::Set(floats, largest_);
    if constexpr (Shape == ElementShape::equal_spheres) {
      reach = hn::Add(reach, hn::Set(floats, tile_.common_radius));
    } else {
      reach = hn::Add(reach, hn::LoadU(floats, tile_.size[0] + p));
    }
    const Numbers cell =
        hn::Sub(hn::LoadU(numbers, tile_.cell + p), hn::Set(numbers, row.first_cell));
    const SideMasks x = sides(0, p, reach, hn::ConvertTo(floats, hn::BitCast(integers, cell)));
    const Numbers one = hn::Set(numbers, 1);
    hn::StoreU(hn::IfThenElseZero(hn::RebindMask(numbers, x.below), one), numbers,
               before_ + (p - first_));
    hn::StoreU(hn::IfThenElseZero(hn::RebindMask(numbers, x.above), one), numbers,
               after_ + (p - first_));

    const SideMasks y = sides(1, p, reach, hn::Set(floats, row.index[1]));
    const Bits y_above = bits_of(y.above) & within;
    append(1, p, y_above);
    if constexpr (Dim == 3) {
      const SideMasks z = sides(2, p, reach, hn::Set(floats, row.index[2]));
      const Bits z_above = bits_of(z.above) & within;
      append(2, p, z_above & bits_of(y.below));
      append(3, p, z_above);
      append(4, p, z_above & y_above);
    }
  }

  /// Faces of the cell within reach, on an axis. Those of a flat tile, where numbers are infinite
  /// or none, are.
  struct SideMasks {
    Mask below;
    Mask above;
  };

  HWY_INLINE SideMasks sides(int axis, std::uint32_t p, Floats reach, Floats index) const {
    const Floats per_unit = hn::Set(floats, tile_.per_unit[axis]);
    const Floats one = hn::Set(floats, 1.0f);
    const Floats q = hn::Add(hn::Mul(hn::LoadU(floats, tile_.center[axis] + p), per_unit), one);
    const Floats within = hn::Sub(q, index);
    const Floats near = hn::Add(hn::Mul(reach, per_unit), hn::Set(floats, nearby_slack));
    return {hn::Not(hn::Gt(within, near)), hn::Not(hn::Lt(within, hn::Sub(one, near)))};
  }

  HWY_INLINE void append(std::size_t k, std::uint32_t p, Bits set) {
    const Numbers number = hn::Iota(numbers, p);
    hn::StoreU(compress(number, set), numbers, list_[k] + size_[k]);
    size_[k] += static_cast<std::size_t>(std::popcount(set));
  }

  const TileView& tile_;
  float largest_;  ///< radius, with the margin and the slack
  std::uint32_t first_ = 0;
  std::size_t size_[Runs] = {};
  std::uint32_t list_[Runs][batch_size + lanes];
  std::uint32_t before_[batch_size + lanes];
  std::uint32_t after_[batch_size + lanes];
};
