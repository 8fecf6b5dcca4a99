// The reach of an element and its candidates, of spheres as squares, included like
// simd_joined_runs-inl.hpp.

/// Spheres of one radius, or boxes: the same bounds for all.
class CommonReach {
 public:
  static constexpr bool counts_all = true;

  HWY_INLINE CommonReach(const LayerPair& layers, std::uint32_t)
      : CommonReach(layers, layers.inner, layers.outer) {}

  /// These bounds instead.
  HWY_INLINE CommonReach(const LayerPair&, float inner, float outer)
      : inner_(hn::Set(floats, inner)), outer_(hn::Set(floats, outer)) {}

  HWY_INLINE CommonReach(const LayerPair& layers, const FarSphere& far)
      : CommonReach(layers, far.nearest, far.farthest) {}

  /// The reach, less the slack, of the candidates from lane k on: of spheres the square.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats inner(const Runs&, std::size_t) const {
    return inner_;
  }
  /// The same plus the slack.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats outer(const Runs&, std::size_t) const {
    return outer_;
  }

 private:
  Floats inner_;
  Floats outer_;
};

/// Spheres: the sum of the radii and the margin.
class SummedReach {
 public:
  static constexpr bool counts_all = true;

  HWY_INLINE SummedReach(const LayerPair& layers, std::uint32_t p)
      : SummedReach(layers, layers.radius[p] + layers.nearest_margin,
                    layers.radius[p] + layers.farthest_margin) {}

  /// An element whose radius and margin come to that, less and plus its slack.
  HWY_INLINE SummedReach(const LayerPair& layers, float nearest, float farthest)
      : radius_(layers.radius),
        nearest_(hn::Set(floats, nearest)),
        farthest_(hn::Set(floats, farthest)) {}

  HWY_INLINE SummedReach(const LayerPair& layers, const FarSphere& far)
      : SummedReach(layers, far.nearest, far.farthest) {}

  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats inner(const Runs& runs, std::size_t k) const {
    const Floats sum = hn::Add(nearest_, runs.load(floats, radius_, k));
    const Floats nearest = hn::Max(sum, hn::Zero(floats));
    return hn::Mul(nearest, nearest);
  }
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats outer(const Runs& runs, std::size_t k) const {
    const Floats farthest = hn::Add(farthest_, runs.load(floats, radius_, k));
    return hn::Mul(farthest, farthest);
  }

 private:
  const float* radius_;
  Floats nearest_;
  Floats farthest_;
};

/// A reach of an element that looks for smaller ones only: those with a smaller radius, or with
/// the same and a lower number.
template <class Reach>
class SmallerReach : public Reach {
 public:
  static constexpr bool counts_all = false;

  HWY_INLINE SmallerReach(const ThreeLayers& layers, std::uint32_t p)
      : Reach(layers, p), layers_(layers) {
    set_size(layers.radius[p], layers.number[p]);
  }

  HWY_INLINE SmallerReach(const ThreeLayers& layers, const FarSphere& far)
      : Reach(layers, far), layers_(layers) {
    set_size(far.radius, far.number);
  }

  /// As whole numbers radii are ordered as they are; a lower number makes the other one less by 1.
  template <class Runs>
  [[nodiscard]] HWY_INLINE hn::Mask<IntegerTag> counts(const Runs& runs, std::size_t k) const {
    const Integers radius = hn::BitCast(integers, runs.load(floats, layers_.radius, k));
    const Integers number = hn::BitCast(integers, runs.load(numbers, layers_.number, k));
    const Integers is_lower = hn::VecFromMask(integers, hn::Lt(number, number_));
    return hn::Lt(hn::Add(radius, is_lower), size_);
  }

 private:
  HWY_INLINE void set_size(float radius, std::uint32_t number) {
    size_ = hn::BitCast(integers, hn::Set(floats, radius));
    number_ = hn::Set(integers, static_cast<std::int32_t>(number));
  }

  const ThreeLayers& layers_;
  Integers size_;
  Integers number_;
};
