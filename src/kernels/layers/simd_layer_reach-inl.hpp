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
      : inner_(inner), outer_(outer) {}

  HWY_INLINE CommonReach(const LayerPair& layers, const FarSphere& far)
      : CommonReach(layers, far.nearest, far.farthest) {}

  /// The reach, less the slack, of the candidates from lane k on: of spheres the square.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto inner(const Runs&, std::size_t) const {
    return hn::Set(Runs::floats, inner_);
  }
  /// The same plus the slack.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto outer(const Runs&, std::size_t) const {
    return hn::Set(Runs::floats, outer_);
  }

 private:
  float inner_;
  float outer_;
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
      : radius_(layers.radius), nearest_(nearest), farthest_(farthest) {}

  HWY_INLINE SummedReach(const LayerPair& layers, const FarSphere& far)
      : SummedReach(layers, far.nearest, far.farthest) {}

  template <class Runs>
  [[nodiscard]] HWY_INLINE auto inner(const Runs& runs, std::size_t k) const {
    const auto sum = hn::Add(hn::Set(Runs::floats, nearest_), runs.load(Runs::floats, radius_, k));
    const auto nearest = hn::Max(sum, hn::Zero(Runs::floats));
    return hn::Mul(nearest, nearest);
  }
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto outer(const Runs& runs, std::size_t k) const {
    const auto farthest =
        hn::Add(hn::Set(Runs::floats, farthest_), runs.load(Runs::floats, radius_, k));
    return hn::Mul(farthest, farthest);
  }

 private:
  const float* radius_;
  float nearest_;
  float farthest_;
};

/// A reach of an element that looks for smaller ones only: those with a smaller radius, or with
/// the same and a lower number.
template <class Reach>
class SmallerReach : public Reach {
 public:
  static constexpr bool counts_all = false;

  HWY_INLINE SmallerReach(const ThreeLayers& layers, std::uint32_t p)
      : Reach(layers, p),
        layers_(layers),
        own_radius_(layers.radius[p]),
        own_number_(static_cast<std::int32_t>(layers.number[p])) {}

  HWY_INLINE SmallerReach(const ThreeLayers& layers, const FarSphere& far)
      : Reach(layers, far),
        layers_(layers),
        own_radius_(far.radius),
        own_number_(static_cast<std::int32_t>(far.number)) {}

  /// As whole numbers radii are ordered as they are; a lower number makes the other one less by 1.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto counts(const Runs& runs, std::size_t k) const {
    constexpr auto tag = Runs::integers;
    const auto radius = hn::BitCast(tag, runs.load(Runs::floats, layers_.radius, k));
    const auto number = hn::BitCast(tag, runs.load(Runs::numbers, layers_.number, k));
    const auto is_lower = hn::VecFromMask(tag, hn::Lt(number, hn::Set(tag, own_number_)));
    return hn::Lt(hn::Add(radius, is_lower), hn::BitCast(tag, hn::Set(Runs::floats, own_radius_)));
  }

 private:
  const ThreeLayers& layers_;
  float own_radius_;
  std::int32_t own_number_;
};
