// Candidates of one element in eight lanes, taken from one run or joined from two, included once
// for each instruction set into the namespace of layer_search_simd.cpp, whose names it uses: no
// include guard, and no includes.

/// What runs are loaded into: a vector of eight lanes, or two of four.
struct EightLanes {
  using FloatTag = kernels::HWY_NAMESPACE::FloatTag;
  using IntegerTag = kernels::HWY_NAMESPACE::IntegerTag;
  using NumberTag = kernels::HWY_NAMESPACE::NumberTag;
  static constexpr FloatTag floats{};
  static constexpr IntegerTag integers{};
  static constexpr NumberTag numbers{};
  static constexpr std::uint32_t capacity = candidates;
  static constexpr std::uint32_t at_once = static_cast<std::uint32_t>(lanes);

  /// The lanes of the set, in order, then others.
  [[nodiscard]] static HWY_INLINE Numbers compress(Numbers values, Bits set) {
    return kernels::HWY_NAMESPACE::compress(values, set);
  }
};

/// Up to eight candidates: lanes 0 .. first - 1 are the first run, the lanes behind it the second.
/// An unaligned load of the one, one of the other that begins `first` places early, and a blend:
///
///   lane     0   1   2   3   4   5   6   7
///   first    a   b   c   .   .   .   .   .      first = 3
///   second   .   .   .   p   q   r   s   t
///
/// What follows the second run is a reach or more away along the row, or padding. Where the first
/// run alone is longer than a vector, the second one is loaded to no end, from a vector before its
/// begin: not from further ahead, which may be before the arrays.
class JoinedRuns : public EightLanes {
 public:
  HWY_INLINE JoinedRuns(const Run& first, const Run& second)
      : begin_(first.begin),
        shifted_(second.begin - std::min(first.end - first.begin, candidates)),
        first_(static_cast<std::int32_t>(first.end - first.begin)),
        size_(first.end - first.begin + (second.end - second.begin)) {}

  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return size_; }

  /// The lanes that candidates have, of a set of hits: all.
  [[nodiscard]] HWY_INLINE Bits inside(Bits hits) const { return hits; }

  template <class Tag, class Number>
  [[nodiscard]] HWY_INLINE hn::Vec<Tag> load(Tag tag, const Number* column,
                                             std::size_t lane) const {
    const auto from_first = lanes_of_first(static_cast<std::int32_t>(lane));
    return hn::IfThenElse(hn::RebindMask(tag, from_first), hn::LoadU(tag, column + begin_ + lane),
                          hn::LoadU(tag, column + std::size_t{shifted_} + lane));
  }

  /// The places from which `load` takes.
  [[nodiscard]] HWY_INLINE Numbers places(std::uint32_t lane) const {
    const auto from_first = lanes_of_first(static_cast<std::int32_t>(lane));
    return hn::IfThenElse(hn::RebindMask(numbers, from_first), numbers_from(begin_ + lane),
                          numbers_from(shifted_ + lane));
  }

 private:
  [[nodiscard]] HWY_INLINE hn::Mask<IntegerTag> lanes_of_first(std::int32_t lane) const {
    return hn::Lt(hn::Iota(integers, 0), hn::Set(integers, first_ - lane));
  }

  std::uint32_t begin_;
  std::uint32_t shifted_;
  std::int32_t first_;
  std::uint32_t size_;
};

/// Candidates of a single run: as many as there are lanes, or fewer.
template <class Lanes>
class RunIn : public Lanes {
 public:
  HWY_INLINE explicit RunIn(const Run& run) : begin_(run.begin), size_(run.end - run.begin) {}

  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return size_; }

  /// Behind an empty run may be what the next one has. A run that does not fit has any.
  [[nodiscard]] HWY_INLINE Bits inside(Bits hits) const {
    return hits & ((Bits{1} << size_ % 32) - 1);
  }

  template <class Tag, class Number>
  [[nodiscard]] HWY_INLINE hn::Vec<Tag> load(Tag tag, const Number* column,
                                             std::size_t lane) const {
    return hn::LoadU(tag, column + begin_ + lane);
  }

  [[nodiscard]] HWY_INLINE Numbers places(std::uint32_t lane) const {
    return numbers_from(begin_ + lane);
  }

 private:
  std::uint32_t begin_;
  std::uint32_t size_;
};

using SingleRun = RunIn<EightLanes>;

/// The first `count` lanes, or all.
[[nodiscard]] HWY_INLINE Bits lanes_before(std::uint32_t count) {
  return count < lanes ? (1u << count) - 1 : all_lanes;
}
