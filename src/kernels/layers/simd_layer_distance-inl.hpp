// What the filter compares with a reach, included like simd_joined_runs-inl.hpp: how far candidates
// are from one element, in all lanes.

/// Where an element is that lies in the box of all.
template <int Dim>
class PlaceInLayers {
 public:
  HWY_INLINE explicit PlaceInLayers(const FarSphere& far) {
    for (int axis = 0; axis < Dim; ++axis) position_[axis] = hn::Set(integers, far.position[axis]);
  }

  /// Of the element at place p.
  HWY_INLINE PlaceInLayers(const LayerPair& layers, std::uint32_t p) {
    for (int axis = 0; axis < Dim; ++axis) {
      position_[axis] = hn::Set(integers, layers.position[axis][p]);
    }
  }

  /// From it to candidates along an axis.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats difference(const LayerPair& layers, const Runs& runs,
                                             std::size_t k, int axis) const {
    return hn::ConvertTo(floats,
                         hn::Sub(runs.load(integers, layers.position[axis], k), position_[axis]));
  }

 private:
  Integers position_[Dim];
};

/// The same of an element that may lie beyond it.
template <int Dim>
class CoarsePlace {
 public:
  HWY_INLINE explicit CoarsePlace(const FarSphere& coarse) : in_layers_(coarse) {
    for (int axis = 0; axis < Dim; ++axis) beyond_[axis] = hn::Set(floats, coarse.beyond[axis]);
  }

  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats difference(const LayerPair& layers, const Runs& runs,
                                             std::size_t k, int axis) const {
    return hn::Sub(in_layers_.difference(layers, runs, k, axis), beyond_[axis]);
  }

 private:
  PlaceInLayers<Dim> in_layers_;
  Floats beyond_[Dim];
};

/// Of spheres: the squares of the distances of their centers.
template <int Dim, class Place = PlaceInLayers<Dim>>
class DistanceSquares {
 public:
  HWY_INLINE explicit DistanceSquares(const FarSphere& far) : place_(far) {}

  /// Of the element at place p.
  HWY_INLINE DistanceSquares(const LayerPair& layers, std::uint32_t p) : place_(layers, p) {}

  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats to(const LayerPair& layers, const Runs& runs,
                                     std::size_t k) const {
    Floats sum = hn::Zero(floats);
    for (int axis = 0; axis < Dim; ++axis) {
      const Floats difference = place_.difference(layers, runs, k, axis);
      const Floats square = hn::Mul(difference, difference);
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
    for (int axis = 0; axis < Dim; ++axis) width_[axis] = hn::Set(floats, far.width[axis]);
  }

  /// Of the element at place p.
  HWY_INLINE BoxGaps(const LayerPair& layers, std::uint32_t p) : place_(layers, p) {
    for (int axis = 0; axis < Dim; ++axis) {
      width_[axis] = hn::Set(floats, layers.width[axis][p]);
    }
  }

  /// A zero is +0: it is a difference of equal numbers.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats to(const LayerPair& layers, const Runs& runs,
                                     std::size_t k) const {
    Floats largest = hn::Zero(floats);
    for (int axis = 0; axis < Dim; ++axis) {
      const Floats difference = place_.difference(layers, runs, k, axis);
      const Floats width = runs.load(floats, layers.width[axis], k);
      const Floats gap = hn::Max(hn::Sub(difference, width_[axis]),
                                 hn::Sub(hn::Sub(hn::Zero(floats), difference), width));
      largest = axis == 0 ? gap : hn::Max(largest, gap);
    }
    return largest;
  }

 private:
  Place place_;
  Floats width_[Dim];
};
