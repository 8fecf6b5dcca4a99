// One element in all lanes, and its candidates, included like simd_joined_runs-inl.hpp.

/// What is nearest beyond the inner bound of a reach among candidates that were tested.
template <class Lanes>
class NearestBeyond {
 public:
  using Vector = hn::Vec<typename Lanes::NumberTag>;

  HWY_INLINE NearestBeyond() : nearest_(hn::Set(Lanes::numbers, ~std::uint32_t{0})) {}

  /// As whole numbers without a sign, of which negative floats are the largest.
  HWY_INLINE void add(Vector beyond) { nearest_ = hn::Min(nearest_, beyond); }

  /// Tells whether nothing is as little beyond it as `band`.
  [[nodiscard]] HWY_INLINE bool is_decided(float band) const {
    const auto bound = hn::BitCast(Lanes::numbers, hn::Set(Lanes::floats, band));
    return hn::AllFalse(Lanes::numbers, hn::Eq(hn::Min(nearest_, bound), nearest_));
  }

 private:
  Vector nearest_;
};

template <class Reach, class Distance>
class LayerProbe {
 public:
  /// Tells whether candidates in any columns are decided as well as those of runs.
  static constexpr bool is_right_beyond_runs = true;

  HWY_INLINE LayerProbe(const LayerPair& layers, const Distance& from, const Reach& reach)
      : layers_(layers), from_(from), reach_(reach) {}

  /// The element at place p.
  template <class Layers>
  [[nodiscard]] static HWY_INLINE LayerProbe at(const Layers& layers, std::uint32_t p) {
    return {layers, Distance(layers, p), Reach(layers, p)};
  }

  /// An element that is far or coarse.
  [[nodiscard]] static HWY_INLINE LayerProbe of(const ThreeLayers& layers, const FarSphere& far) {
    return {layers, Distance(far), Reach(layers, far)};
  }

  template <class Lanes>
  using Nearest = NearestBeyond<Lanes>;

  /// The candidates that are certainly within reach.
  template <class Runs, class Lanes>
  [[nodiscard]] HWY_INLINE Bits test(const Runs& runs, NearestBeyond<Lanes>& nearest) const {
    Bits hits = 0;
    for (std::size_t k = 0; k < Runs::capacity; k += Runs::at_once) {
      const auto beyond = hn::Sub(distance(runs, k), reach_.inner(runs, k));
      hits |= lanes_that_count(runs, k, hn::Lt(beyond, hn::Zero(Runs::floats))) << k;
      nearest.add(those_that_count(runs, k, hn::BitCast(Runs::numbers, beyond)));
    }
    return runs.inside(hits);
  }

  /// The candidates from lane k on that may be within reach.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Bits hits(const Runs& runs, std::size_t k, Floats distance) const {
    return lanes_that_count(runs, k, hn::Le(distance, reach_.outer(runs, k)));
  }
  /// Those that certainly are.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Mask is_sure(const Runs& runs, std::size_t k, Floats distance) const {
    return hn::Lt(distance, reach_.inner(runs, k));
  }

  /// What is compared with the bounds of the reach.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto distance(const Runs& runs, std::size_t k) const {
    return from_.to(layers_, runs, k);
  }

 private:
  template <class Runs>
  [[nodiscard]] HWY_INLINE Bits lanes_that_count(const Runs& runs, std::size_t k,
                                                 hn::Mask<typename Runs::FloatTag> set) const {
    if constexpr (Reach::counts_all) {
      return bits_of(Runs::floats, set);
    } else {
      const auto counts = hn::RebindMask(Runs::floats, reach_.counts(runs, k));
      return bits_of(Runs::floats, hn::And(set, counts));
    }
  }

  /// The largest number in place of others.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto those_that_count(const Runs& runs, std::size_t k,
                                                 hn::Vec<typename Runs::NumberTag> values) const {
    if constexpr (Reach::counts_all) {
      return values;
    } else {
      const auto counts = hn::RebindMask(Runs::numbers, reach_.counts(runs, k));
      return hn::IfThenElse(counts, values, hn::Set(Runs::numbers, ~std::uint32_t{0}));
    }
  }

  const LayerPair& layers_;
  Distance from_;
  Reach reach_;
};
