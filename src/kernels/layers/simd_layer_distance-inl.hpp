// What the filter compares with a reach, included like simd_joined_runs-inl.hpp: how far candidates
// are from one element, in all lanes.

/// Where an element is that lies in the box of all.
template <int Dim>
class PlaceInLayers {
 public:
  HWY_INLINE explicit PlaceInLayers(const FarSphere& far) {
    for (int axis = 0; axis < Dim; ++axis) position_[axis] = far.position[axis];
  }

  /// Of the element at place p.
  HWY_INLINE PlaceInLayers(const LayerPair& layers, std::uint32_t p) {
    for (int axis = 0; axis < Dim; ++axis) position_[axis] = layers.position[axis][p];
  }

  /// From it to candidates along an axis.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto difference(const LayerPair& layers, const Runs& runs, std::size_t k,
                                           int axis) const {
    const auto position = runs.load(Runs::integers, layers.position[axis], k);
    return hn::ConvertTo(Runs::floats, hn::Sub(position, hn::Set(Runs::integers, position_[axis])));
  }

 private:
  std::int32_t position_[Dim];
};

/// The same of an element that may lie beyond it.
template <int Dim>
class CoarsePlace {
 public:
  HWY_INLINE explicit CoarsePlace(const FarSphere& coarse) : in_layers_(coarse) {
    for (int axis = 0; axis < Dim; ++axis) beyond_[axis] = coarse.beyond[axis];
  }

  template <class Runs>
  [[nodiscard]] HWY_INLINE auto difference(const LayerPair& layers, const Runs& runs, std::size_t k,
                                           int axis) const {
    return hn::Sub(in_layers_.difference(layers, runs, k, axis),
                   hn::Set(Runs::floats, beyond_[axis]));
  }

 private:
  PlaceInLayers<Dim> in_layers_;
  float beyond_[Dim];
};

/// Of spheres: the squares of the distances of their centers.
template <int Dim, class Place = PlaceInLayers<Dim>>
class DistanceSquares {
 public:
  HWY_INLINE explicit DistanceSquares(const FarSphere& far) : place_(far) {}

  /// Of the element at place p.
  HWY_INLINE DistanceSquares(const LayerPair& layers, std::uint32_t p) : place_(layers, p) {}

  template <class Runs>
  [[nodiscard]] HWY_INLINE auto to(const LayerPair& layers, const Runs& runs, std::size_t k) const {
    auto sum = hn::Zero(Runs::floats);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto difference = place_.difference(layers, runs, k, axis);
      const auto square = hn::Mul(difference, difference);
      sum = axis == 0 ? square : hn::Add(sum, square);
    }
    return sum;
  }

 private:
  Place place_;
};

/// Of boxes: their gap, the largest one over the axes, negative where they overlap on each of them.
/// With d for the difference of the lower ends, candidate less element, that on an axis is the
/// larger one of
///
///   d - width of the element        lower end of the candidate less upper end of the element
///   -d - width of the candidate     the same with the two exchanged
template <int Dim, class Place = PlaceInLayers<Dim>>
class BoxGaps {
 public:
  HWY_INLINE explicit BoxGaps(const FarSphere& far) : place_(far) {
    for (int axis = 0; axis < Dim; ++axis) width_[axis] = far.width[axis];
  }

  /// Of the element at place p.
  HWY_INLINE BoxGaps(const LayerPair& layers, std::uint32_t p) : place_(layers, p) {
    for (int axis = 0; axis < Dim; ++axis) width_[axis] = layers.width[axis][p];
  }

  /// A zero is +0: it is a difference of equal numbers.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto to(const LayerPair& layers, const Runs& runs, std::size_t k) const {
    const auto zero = hn::Zero(Runs::floats);
    auto largest = zero;
    for (int axis = 0; axis < Dim; ++axis) {
      const auto difference = place_.difference(layers, runs, k, axis);
      const auto width = runs.load(Runs::floats, layers.width[axis], k);
      const auto gap = hn::Max(hn::Sub(difference, hn::Set(Runs::floats, width_[axis])),
                               hn::Sub(hn::Sub(zero, difference), width));
      largest = axis == 0 ? gap : hn::Max(largest, gap);
    }
    return largest;
  }

 private:
  Place place_;
  float width_[Dim];
};
