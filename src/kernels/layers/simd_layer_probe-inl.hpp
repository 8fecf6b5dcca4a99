// One element in all lanes, and its candidates, included like simd_joined_runs-inl.hpp.

template <class Reach, class Distance>
class LayerProbe {
 public:
  HWY_INLINE LayerProbe(const LayerPair& layers, const Distance& from, const Reach& reach)
      : layers_(layers),
        from_(from),
        reach_(reach),
        nearest_(hn::Set(numbers, ~std::uint32_t{0})) {}

  /// The element at place p.
  template <class Layers>
  [[nodiscard]] static HWY_INLINE LayerProbe at(const Layers& layers, std::uint32_t p) {
    return {layers, Distance(layers, p), Reach(layers, p)};
  }

  /// An element that is far or coarse.
  [[nodiscard]] static HWY_INLINE LayerProbe of(const ThreeLayers& layers, const FarSphere& far) {
    return {layers, Distance(far), Reach(layers, far)};
  }

  /// The candidates that are certainly within reach; writes down the numbers of all.
  template <class Runs>
  HWY_INLINE Bits test(const Runs& runs, std::uint32_t* number) {
    Bits hits = 0;
    for (std::size_t k = 0; k < candidates; k += lanes) {
      const Floats beyond = hn::Sub(distance(runs, k), reach_.inner(runs, k));
      const Mask is_sure = hn::Lt(beyond, hn::Zero(floats));
      // As whole numbers without a sign, negative floats are the largest.
      Numbers size = hn::BitCast(numbers, beyond);
      if constexpr (Reach::counts_all) {
        hits |= bits_of(is_sure) << k;
      } else {
        const auto counts = reach_.counts(runs, k);
        hits |= bits_of(hn::And(is_sure, hn::RebindMask(floats, counts))) << k;
        size = hn::IfThenElse(hn::RebindMask(numbers, counts), size,
                              hn::Set(numbers, ~std::uint32_t{0}));
      }
      nearest_ = hn::Min(nearest_, size);
      hn::StoreU(runs.load(numbers, layers_.number, k), numbers, number + k);
    }
    return hits;
  }

  /// Tells whether none is as little beyond the inner bound as `band`.
  [[nodiscard]] HWY_INLINE bool is_decided(Numbers band) const {
    return hn::AllFalse(numbers, hn::Eq(hn::Min(nearest_, band), nearest_));
  }

  /// The candidates from lane k on that may be within reach.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Bits hits(const Runs& runs, std::size_t k, Floats distance) const {
    const Mask is_hit = hn::Le(distance, reach_.outer(runs, k));
    if constexpr (Reach::counts_all) {
      return bits_of(is_hit);
    } else {
      return bits_of(hn::And(is_hit, hn::RebindMask(floats, reach_.counts(runs, k))));
    }
  }
  /// Those that certainly are.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Mask is_sure(const Runs& runs, std::size_t k, Floats distance) const {
    return hn::Lt(distance, reach_.inner(runs, k));
  }

  /// What is compared with the bounds of the reach.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats distance(const Runs& runs, std::size_t k) const {
    return from_.to(layers_, runs, k);
  }

 private:
  const LayerPair& layers_;
  Distance from_;
  Reach reach_;
  Numbers nearest_;
};
