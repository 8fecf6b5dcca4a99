// An element in all lanes beside eight candidates at a time, included like
// simd_pair_tester-inl.hpp.

/// Columns in which the candidates stand.
struct Columns {
  const float* center[3];
  const float* size[3];
  const std::uint32_t* number;
};

template <class Tag>
struct FilteredLanes {
  hn::Mask<Tag> hit;   ///< not certainly apart
  hn::Mask<Tag> sure;  ///< certainly within reach
};

using Filtered = FilteredLanes<FloatTag>;

/// Spheres, or equal spheres.
template <int Dim, ElementShape Shape, class Tag = FloatTag>
class SimdProbe {
  using Floats = hn::Vec<Tag>;
  using NumberTag = hn::RebindToUnsigned<Tag>;
  using Numbers = hn::Vec<NumberTag>;
  using Filtered = FilteredLanes<Tag>;
  static constexpr Tag floats{};
  static constexpr NumberTag numbers{};

 public:
  /// Columns that say how large a candidate is.
  static constexpr int size_columns = Shape == ElementShape::equal_spheres ? 0 : 1;

  HWY_INLINE SimdProbe(const SearchedElements& elements, const SearchJob& job, std::uint32_t p) {
    for (int axis = 0; axis < Dim; ++axis)
      center_[axis] = hn::Set(floats, elements.center[axis][p]);
    set_reach(elements, job, equal ? elements.common_radius : elements.size[0][p], job.slack);
    number_ = hn::Set(numbers, elements.number[p]);
  }

  /// Makes it the probe of another element of these, but for its number. Among equal spheres the
  /// reach stays the same.
  HWY_INLINE void move_to(const Columns& columns, const SearchedElements& elements,
                          const SearchJob& job, std::uint32_t p) {
    for (int axis = 0; axis < Dim; ++axis) {
      center_[axis] = hn::Set(floats, columns.center[axis][p]);
    }
    if constexpr (!equal) set_reach(elements, job, columns.size[0][p], job.slack);
  }

  HWY_INLINE SimdProbe(const SearchedElements& elements, const SearchJob& job,
                       const CoarseElement& coarse) {
    for (int axis = 0; axis < Dim; ++axis) center_[axis] = hn::Set(floats, coarse.center[axis]);
    set_reach(elements, job, coarse.size[0], coarse.slack);
    number_ = hn::Set(numbers, coarse.number);
  }

  [[nodiscard]] HWY_INLINE Numbers number() const { return number_; }

  [[nodiscard]] HWY_INLINE Filtered filter(const Columns& columns, std::size_t q) const {
    Floats difference = hn::Sub(center_[0], hn::LoadU(floats, columns.center[0] + q));
    Floats distance_squared = hn::Mul(difference, difference);
    for (int axis = 1; axis < Dim; ++axis) {
      difference = hn::Sub(center_[axis], hn::LoadU(floats, columns.center[axis] + q));
      distance_squared = hn::Add(distance_squared, hn::Mul(difference, difference));
    }
    if constexpr (equal) {
      return {hn::Le(distance_squared, outer_), hn::Lt(distance_squared, inner_)};
    } else {
      const Floats radius = hn::LoadU(floats, columns.size[0] + q);
      const Floats farthest = hn::Add(outer_, radius);
      const Floats nearest = hn::Max(hn::Add(inner_, radius), hn::Zero(floats));
      return {hn::Le(distance_squared, hn::Mul(farthest, farthest)),
              hn::Lt(distance_squared, hn::Mul(nearest, nearest))};
    }
  }

 private:
  static constexpr bool equal = Shape == ElementShape::equal_spheres;

  HWY_INLINE void set_reach(const SearchedElements& elements, const SearchJob& job, float radius,
                            float slack) {
    const float reach = radius + job.margin + (equal ? elements.common_radius : 0.0f);
    outer_ = hn::Set(floats, reach + slack);
    inner_ = hn::Set(floats, reach - slack);
    if constexpr (equal) {
      outer_ = hn::Mul(outer_, outer_);
      inner_ = hn::Max(inner_, hn::Zero(floats));
      inner_ = hn::Mul(inner_, inner_);
    }
  }

  Floats center_[Dim];
  Floats outer_;  ///< reach + slack and reach - slack, the element's own part of it,
  Floats inner_;  ///< or the squares of the whole, where all radii are equal
  Numbers number_;
};

/// Boxes: on each axis neither may lie behind the other's end.
template <int Dim, class Tag>
class SimdProbe<Dim, ElementShape::boxes, Tag> {
  using Floats = hn::Vec<Tag>;
  using NumberTag = hn::RebindToUnsigned<Tag>;
  using Numbers = hn::Vec<NumberTag>;
  using Filtered = FilteredLanes<Tag>;
  static constexpr Tag floats{};
  static constexpr NumberTag numbers{};

 public:
  static constexpr int size_columns = Dim;

  HWY_INLINE SimdProbe(const SearchedElements& elements, const SearchJob& job, std::uint32_t p) {
    for (int axis = 0; axis < Dim; ++axis) {
      set_axis(axis, elements.center[axis][p], elements.size[axis][p], job.margin, job.slack);
    }
    set_reach(job.margin, job.slack);
    number_ = hn::Set(numbers, elements.number[p]);
  }

  /// Makes it the probe of another element of these, but for its number.
  HWY_INLINE void move_to(const Columns& columns, const SearchedElements&, const SearchJob& job,
                          std::uint32_t p) {
    for (int axis = 0; axis < Dim; ++axis) {
      set_axis(axis, columns.center[axis][p], columns.size[axis][p], job.margin, job.slack);
    }
  }

  HWY_INLINE SimdProbe(const SearchedElements&, const SearchJob& job, const CoarseElement& coarse) {
    for (int axis = 0; axis < Dim; ++axis) {
      set_axis(axis, coarse.center[axis], coarse.size[axis], job.margin, coarse.slack);
    }
    set_reach(job.margin, coarse.slack);
    number_ = hn::Set(numbers, coarse.number);
  }

  [[nodiscard]] HWY_INLINE Numbers number() const { return number_; }

  [[nodiscard]] HWY_INLINE Filtered filter(const Columns& columns, std::size_t q) const {
    Filtered result = filter_axis<0>(columns, q);
    const auto narrow = [&](const Filtered& axis) {
      result = {hn::And(result.hit, axis.hit), hn::And(result.sure, axis.sure)};
    };
    narrow(filter_axis<1>(columns, q));
    if constexpr (Dim == 3) narrow(filter_axis<2>(columns, q));
    return result;
  }

 private:
  HWY_INLINE void set_axis(int axis, float lower, float width, float margin, float slack) {
    lower_[axis] = hn::Set(floats, lower);
    before_[axis] = hn::Set(floats, -(width + (margin + slack)));
    surely_before_[axis] = hn::Set(floats, -(width + (margin - slack)));
  }

  HWY_INLINE void set_reach(float margin, float slack) {
    outer_ = hn::Set(floats, margin + slack);
    inner_ = hn::Set(floats, margin - slack);
  }

  template <int Axis>
  [[nodiscard]] HWY_INLINE Filtered filter_axis(const Columns& columns, std::size_t q) const {
    const Floats behind = hn::Sub(lower_[Axis], hn::LoadU(floats, columns.center[Axis] + q));
    const Floats width = hn::LoadU(floats, columns.size[Axis] + q);
    return {hn::And(hn::Le(behind, hn::Add(width, outer_)), hn::Ge(behind, before_[Axis])),
            hn::And(hn::Lt(behind, hn::Add(width, inner_)), hn::Gt(behind, surely_before_[Axis]))};
  }

  Floats lower_[Dim];
  Floats before_[Dim];         ///< how far the element may lie before a candidate, negative ...
  Floats surely_before_[Dim];  ///< ... or does so for certain
  Floats outer_;               ///< margin + slack, margin - slack
  Floats inner_;
  Numbers number_;
};
