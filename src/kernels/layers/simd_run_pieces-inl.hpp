// The runs of one element cut into vectors, included like simd_joined_runs-inl.hpp.

/// The vectors of some runs, one after the other, and how long these are. How many a run takes
/// could not be foreseen: short ones are cut without a branch.
template <std::size_t runs>
class RunPieces {
 public:
  /// Runs with more candidates are not cut.
  static constexpr std::uint32_t longest = 16 * candidates;
  static constexpr std::size_t most = runs * longest / candidates;

  HWY_INLINE void add(const Run& run) {
    const std::uint32_t size = run.end - run.begin;
    tests_ += size;
    has_long_runs_ |= size > candidates;
    std::uint32_t begin = run.begin;
    if (HWY_UNLIKELY(size > short_run)) {
      is_large_ |= size > longest;
      if (is_large_) return;
      begin = add_begin_of_long(run);
    }
    std::uint32_t count = count_;
    for (std::uint32_t k = 0; k < short_run; k += candidates) {
      // One that is not needed is overwritten.
      pieces_[count] = {begin + k, run.end};
      count += begin + k < run.end ? 1 : 0;
    }
    count_ = count;
  }

  [[nodiscard]] HWY_INLINE bool is_large() const { return is_large_; }
  [[nodiscard]] HWY_INLINE bool has_long_runs() const { return has_long_runs_; }
  [[nodiscard]] HWY_INLINE std::uint32_t tests() const { return tests_; }

  /// Piece k begins there; its run may end behind it.
  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return count_; }
  [[nodiscard]] HWY_INLINE SingleRun operator[](std::uint32_t k) const {
    return SingleRun(pieces_[k]);
  }

 private:
  /// Most runs have no more candidates.
  static constexpr std::uint32_t short_run = 2 * candidates;

  /// Leaves the end of the run, a short one, whose begin it returns.
  HWY_INLINE std::uint32_t add_begin_of_long(const Run& run) {
    std::uint32_t begin = run.begin;
    for (; run.end - begin > short_run; begin += candidates) {
      pieces_[count_++] = {begin, begin + candidates};
    }
    return begin;
  }

  std::uint32_t count_ = 0;
  std::uint32_t tests_ = 0;
  bool has_long_runs_ = false;
  bool is_large_ = false;
  Run pieces_[most + short_run / candidates];
};
