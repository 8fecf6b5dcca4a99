// The runs of a block of cells, gathered into one, included like simd_pair_tester-inl.hpp.

/// Candidates of all elements of a block, one behind the other.
template <int Dim, ElementShape Shape>
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
  /// them is within reach of nothing. Whole vectors: the excess is overwritten. Those of the tag
  /// are to be the ones that will be read: a processor waits for what it reads of several writes.
  template <class Tag>
  HWY_INLINE std::size_t gather(Tag tag, const Columns& from, std::span<const Run> runs,
                                const SearchJob& job) const {
    constexpr hn::RebindToUnsigned<Tag> number_tag{};
    constexpr std::size_t length = hn::MaxLanes(Tag());
    float* to[6];
    std::copy_n(job.block, 6, to);
    std::uint32_t* const number = job.block_number;
    std::size_t size = 0;
    for (const Run& run : runs) {
      for (std::size_t k = 0; run.begin + k < run.end; k += length) {
        const std::size_t q = run.begin + k;
        const std::size_t place = size + k;
        for (int axis = 0; axis < Dim; ++axis) {
          hn::StoreU(hn::LoadU(tag, from.center[axis] + q), tag, to[axis] + place);
        }
        for (int column = 0; column < size_columns; ++column) {
          hn::StoreU(hn::LoadU(tag, from.size[column] + q), tag, to[3 + column] + place);
        }
        hn::StoreU(hn::LoadU(number_tag, from.number + q), number_tag, number + place);
      }
      size += run.end - run.begin;
    }
    hn::StoreU(hn::Set(tag, far_away), tag, to[0] + size);
    for (int column = 0; column < size_columns; ++column) {
      hn::StoreU(hn::Zero(tag), tag, to[3 + column] + size);
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

  Columns columns_;
};
