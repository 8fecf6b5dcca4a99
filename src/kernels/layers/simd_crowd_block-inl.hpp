// The candidates of a crowd side by side, included like simd_joined_runs-inl.hpp.

/// What some elements meet that stand side by side in a row. They look in nearly the same columns,
/// so their runs are copied once, one behind the other, and each of them meets all of that:
///
///   block      0   1   2   3   ...                                          size
///              | own row, from the first element on | run 1 | run 2 | ...
///              element e |<----------- candidates of element e ----------->|
///
/// What it meets there beyond its own columns is further away than its reach.
class CrowdBlock {
 public:
  /// Larger crowds are not copied.
  static constexpr std::uint32_t most = 960;
  static_assert(most + widest_vector <= HitBuffer::size, "an element may touch all of them");

  HWY_INLINE explicit CrowdBlock(const LayerPair& layers) : source_(layers), view_(layers) {
    for (int axis = 0; axis < 3; ++axis) {
      view_.position[axis] = position_[axis];
      if (layers.width[axis] != nullptr) view_.width[axis] = width_[axis];
    }
    view_.number = number_;
    if (layers.radius != nullptr) view_.radius = radius_;
  }

  /// Copies runs, the first of which begins with the elements, or returns false where they are too
  /// long.
  template <std::size_t runs>
  HWY_INLINE bool fill(const std::array<Run, runs>& its) {
    std::uint32_t size = 0;
    for (const Run& run : its) size += run.end - run.begin;
    if (size > most) return false;
    size_ = 0;
    // A local copy, whose members stay in registers while columns are written.
    const LayerPair source = source_;
    for (const Run& run : its) {
      const std::uint32_t length = run.end - run.begin;
      // Whole vectors: the excess is overwritten.
      for (std::uint32_t k = 0; k < length; k += wide_lanes) {
        copy_columns(source, run.begin + k, size_ + k);
      }
      size_ += length;
    }
    return true;
  }

  [[nodiscard]] HWY_INLINE std::uint32_t size() const { return size_; }

  /// Layers that have what was copied at its places in the block.
  [[nodiscard]] HWY_INLINE const LayerPair& layers() const { return view_; }

 private:
  HWY_INLINE void copy_columns(const LayerPair& source, std::uint32_t from, std::uint32_t to) {
    for (int axis = 0; axis < 3; ++axis) {
      copy(source.position[axis] + from, position_[axis] + to);
      if (source.width[axis] != nullptr) copy(source.width[axis] + from, width_[axis] + to);
    }
    copy(source.number + from, number_ + to);
    if (source.radius != nullptr) copy(source.radius + from, radius_ + to);
  }

  template <class Number>
  static HWY_INLINE void copy(const Number* from, Number* to) {
    constexpr hn::Rebind<Number, WideTag> tag{};
    hn::StoreU(hn::LoadU(tag, from), tag, to);
  }

  static constexpr std::size_t room = most + 2 * widest_vector;

  const LayerPair& source_;
  LayerPair view_;
  std::uint32_t size_ = 0;
  std::int32_t position_[3][room];
  std::uint32_t number_[room];
  float radius_[room];
  float width_[3][room];
};
