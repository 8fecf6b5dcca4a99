// The elements that one element meets, in vectors, while they are being found; included like
// simd_pair_tester-inl.hpp.

/// Any runs. What follows one in memory may lie anywhere in the tile.
struct RunList {
  static constexpr bool harmless_beyond = false;
  std::span<const Run> runs;

  [[nodiscard]] HWY_INLINE std::size_t size() const { return runs.size(); }
  [[nodiscard]] HWY_INLINE const Run& operator[](std::size_t r) const { return runs[r]; }
};

/// The partners of an element while they are being found.
template <class Probe>
class SimdRow {
 public:
  HWY_INLINE explicit SimdRow(std::uint32_t* begin)
      : end_(begin), undecided_(hn::MaskFromVec(hn::Zero(floats))) {}

  /// The wanted candidates in the vector from q on. Without a branch: nothing to guess.
  HWY_INLINE void write_all(const Probe& probe, const Columns& columns, std::size_t q,
                            Bits wanted) {
    const Filtered filtered = probe.filter(columns, q);
    undecided_ = hn::Or(undecided_, hn::AndNot(filtered.sure, filtered.hit));
    const Bits hits = bits_of(filtered.hit) & wanted;
    hn::StoreU(compress(hn::LoadU(numbers, columns.number + q), hits), numbers, end_);
    end_ += std::popcount(hits);
  }

  [[nodiscard]] HWY_INLINE std::uint32_t* end() const { return end_; }
  [[nodiscard]] HWY_INLINE bool is_decided() const { return hn::AllFalse(floats, undecided_); }

 private:
  std::uint32_t* end_;
  Mask undecided_;
};
