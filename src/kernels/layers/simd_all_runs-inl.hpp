// All runs of an element in one vector, included like simd_joined_runs-inl.hpp.

/// A vector of sixteen lanes, where the processor has them.
struct SixteenLanes {
  using FloatTag = WideTag;
  using IntegerTag = hn::RebindToSigned<WideTag>;
  using NumberTag = hn::RebindToUnsigned<WideTag>;
  static constexpr FloatTag floats{};
  static constexpr IntegerTag integers{};
  static constexpr NumberTag numbers{};
  static constexpr std::uint32_t capacity = 16;
  static constexpr std::uint32_t at_once = 16;

  /// The lanes of the set, in order.
  [[nodiscard]] static HWY_INLINE hn::Vec<NumberTag> compress(hn::Vec<NumberTag> values, Bits set) {
    return hn::Compress(values, lanes_of(numbers, set));
  }

 protected:
  template <class Tag>
  [[nodiscard]] static HWY_INLINE hn::Mask<Tag> lanes_of(Tag tag, Bits set) {
    const auto low = static_cast<std::uint16_t>(set);
    std::uint8_t bits[8] = {};
    std::memcpy(bits, &low, sizeof(low));
    return hn::LoadMaskBits(tag, bits);
  }
};

/// Candidates of a single run in the most lanes that the processor has.
using WidestLanes = std::conditional_t<wide_lanes == 16, SixteenLanes, EightLanes>;
using WidestRun = RunIn<WidestLanes>;

/// The same where all lanes have candidates.
class FullVector : public WidestRun {
 public:
  HWY_INLINE explicit FullVector(std::uint32_t begin)
      : WidestRun({begin, begin + WidestRun::capacity}) {}

  [[nodiscard]] HWY_INLINE Bits inside(Bits hits) const { return hits; }
};

/// Some runs of an element, from the first of them on, one behind the other. Each is loaded from as
/// many places before its begin as there are lanes before its own, and what is in the lanes behind
/// it is replaced by the next one:
///
///   lane     0   1   2   3   4   5   6   7   8  ...
///   run 0    a   b   c   .   .   .   .   .   .
///   run 1                p   q   .   .   .   .
///   run 2                        u   v   w   .
template <std::size_t first, std::size_t count>
class RunsInSixteen : public SixteenLanes {
 public:
  template <class RunsOfElement>
  HWY_INLINE explicit RunsInSixteen(const RunsOfElement& its) {
    add(its, std::make_index_sequence<count>());
  }

  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return size_; }

  /// Runs that do not fit might be read from before the arrays.
  [[nodiscard]] HWY_INLINE bool fit() const { return size_ <= capacity; }

  [[nodiscard]] HWY_INLINE Bits inside(Bits hits) const {
    return hits & ((Bits{1} << size_ % 32) - 1);
  }

  template <class Tag, class Number>
  [[nodiscard]] HWY_INLINE hn::Vec<Tag> load(Tag tag, const Number* column, std::size_t) const {
    auto all = hn::LoadU(tag, column + shifted_[0]);
    for (std::size_t r = 1; r < count; ++r) {
      const auto from_run = lanes_of(tag, 0xffffU << before_[r]);
      all = hn::IfThenElse(from_run, hn::LoadU(tag, column + shifted_[r]), all);
    }
    return all;
  }

 private:
  template <class RunsOfElement, std::size_t... r>
  HWY_INLINE void add(const RunsOfElement& its, std::index_sequence<r...>) {
    (add(r, its.template run<first + r>()), ...);
  }

  HWY_INLINE void add(std::size_t r, const Run& run) {
    before_[r] = size_;
    shifted_[r] = run.begin - size_;
    size_ += run.end - run.begin;
  }

  std::uint32_t size_ = 0;
  std::uint32_t before_[count];   ///< candidates of the runs before it
  std::uint32_t shifted_[count];  ///< place from which it is loaded
};

/// The two runs of a disc or rectangle, which fit eight lanes as well.
class BothRuns : public JoinedRuns {
 public:
  template <class RunsOfElement>
  HWY_INLINE explicit BothRuns(const RunsOfElement& its)
      : JoinedRuns(its.template run<0>(), its.template run<1>()) {}

  [[nodiscard]] HWY_INLINE bool fit() const { return size() <= capacity; }
};

/// Vectors that hold all runs of an element: one, or two for elements with more candidates.
template <std::size_t runs>
using AllRuns = std::conditional_t<runs == 2, BothRuns, RunsInSixteen<0, runs>>;
using FirstHalf = RunsInSixteen<0, 3>;
using SecondHalf = RunsInSixteen<3, 2>;

/// Tells whether the processor has such vectors for so many runs.
template <std::size_t runs>
constexpr bool fit_one_vector = runs == 2 ? lanes == candidates : wide_lanes == 16;
