// The runs of one element cut into vectors, included like simd_joined_runs-inl.hpp.

/// The vectors of some runs, one after the other, and how long these are. How many a run takes
/// could not be foreseen: short ones are cut without a branch.
template <std::size_t runs>
class RunPieces {
 public:
  static constexpr std::uint32_t capacity = WidestRun::capacity;
  /// Runs with more candidates are not cut.
  static constexpr std::uint32_t longest = 128;
  static constexpr std::size_t most = runs * longest / capacity;

  HWY_INLINE void add(const Run& run) {
    const std::uint32_t size = run.end - run.begin;
    tests_ += size;
    longest_run_ = std::max(longest_run_, size);
    std::uint32_t begin = run.begin;
    if (HWY_UNLIKELY(size > short_run)) {
      is_large_ |= size > longest;
      if (is_large_) return;
      begin = add_begin_of_long(run);
    }
    std::uint32_t count = count_;
    for (std::uint32_t k = 0; k < short_run; k += capacity) {
      // One that is not needed is overwritten.
      pieces_[count] = {begin + k, std::min(begin + k + capacity, run.end)};
      count += begin + k < run.end ? 1 : 0;
    }
    count_ = count;
  }

  [[nodiscard]] HWY_INLINE bool is_large() const { return is_large_; }
  [[nodiscard]] HWY_INLINE std::uint32_t longest_run() const { return longest_run_; }
  [[nodiscard]] HWY_INLINE std::uint32_t tests() const { return tests_; }

  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return count_; }
  [[nodiscard]] HWY_INLINE WidestRun operator[](std::uint32_t k) const {
    return WidestRun(pieces_[k]);
  }

 private:
  /// Most runs have no more candidates.
  static constexpr std::uint32_t short_run = 2 * capacity;

  /// Leaves the end of the run, a short one, whose begin it returns.
  HWY_INLINE std::uint32_t add_begin_of_long(const Run& run) {
    std::uint32_t begin = run.begin;
    for (; run.end - begin > short_run; begin += capacity) {
      pieces_[count_++] = {begin, begin + capacity};
    }
    return begin;
  }

  std::uint32_t count_ = 0;
  std::uint32_t tests_ = 0;
  std::uint32_t longest_run_ = 0;
  bool is_large_ = false;
  Run pieces_[most + short_run / capacity];
};
