// The runs of a block of cells, gathered into one, included like simd_pair_tester-inl.hpp.

/// Candidates of all elements of a block, one behind the other.
template <int Dim, TileShape Shape>
class SimdBlock {
 public:
  /// Vectors of candidates, each of one element, in which the filter leaves some.
  struct VectorList {
    static constexpr std::size_t most = 512;
    std::uint32_t element[most];
    std::uint32_t candidates[most];  ///< the first one
    Bits hits[most];                 ///< not certainly apart
  };

  HWY_INLINE explicit SimdBlock(const SearchJob& job)
      : columns_{{job.block[0], job.block[1], job.block[2]},
                 {job.block[3], job.block[4], job.block[5]},
                 job.block_number} {}

  [[nodiscard]] HWY_INLINE const Columns& columns() const { return columns_; }

  /// Puts the runs one behind the other and returns how many candidates there are; what follows
  /// them is within reach of nothing. Whole vectors: the excess is overwritten.
  HWY_INLINE std::size_t gather(const Columns& from, std::span<const Run> runs,
                                const SearchJob& job) const {
    float* to[6];
    std::copy_n(job.block, 6, to);
    std::uint32_t* const number = job.block_number;
    std::size_t size = 0;
    for (const Run& run : runs) {
      for (std::size_t k = 0; run.begin + k < run.end; k += wide_lanes) {
        const std::size_t q = run.begin + k;
        for (int axis = 0; axis < Dim; ++axis) copy(from.center[axis] + q, to[axis] + size + k);
        for (int column = 0; column < size_columns; ++column) {
          copy(from.size[column] + q, to[3 + column] + size + k);
        }
        hn::StoreU(hn::LoadU(wide_numbers, from.number + q), wide_numbers, number + size + k);
      }
      size += run.end - run.begin;
    }
    hn::StoreU(hn::Set(wide_floats, far_away), wide_floats, to[0] + size);
    for (int column = 0; column < size_columns; ++column) {
      hn::StoreU(hn::Zero(wide_floats), wide_floats, to[3 + column] + size);
    }
    return size;
  }

  /// Vectors that the list may grow by for one element.
  [[nodiscard]] static constexpr std::size_t most_vectors(std::size_t size) {
    return size / wide_lanes + 1;
  }

  /// Adds to a list of so many vectors those of the element at place p, whose candidates are
  /// [first, size), and returns how many there are then. Without a branch that depends on the data.
  HWY_INLINE std::size_t list(const TileView& tile, const SearchJob& job, std::uint32_t p,
                              std::size_t first, std::size_t size, VectorList& left,
                              std::size_t count) const {
    const SimdProbe<Dim, Shape, WideTag> probe(tile, job, p);
    const Columns columns = columns_;
    Bits wanted = ~Bits{0} << first % wide_lanes;
    for (std::size_t q = first / wide_lanes * wide_lanes; q < size; q += wide_lanes) {
      const Bits hits = wide_bits_of(probe.filter(columns, q).hit) & wanted;
      wanted = ~Bits{0};
      left.element[count] = p;
      left.candidates[count] = static_cast<std::uint32_t>(q);
      left.hits[count] = hits;
      count += hits != 0 ? 1 : 0;
    }
    return count;
  }

 private:
  static constexpr int size_columns = SimdProbe<Dim, Shape>::size_columns;

  static HWY_INLINE void copy(const float* from, float* to) {
    hn::StoreU(hn::LoadU(wide_floats, from), wide_floats, to);
  }

  Columns columns_;
};
