// One element in all lanes, and the distances of its candidates, included like
// simd_joined_runs-inl.hpp.

template <int Dim, class Reach>
class LayerProbe {
 public:
  HWY_INLINE LayerProbe(const LayerPair& layers, const std::int32_t (&position)[3],
                        const Reach& reach)
      : layers_(layers), reach_(reach), nearest_(hn::Set(numbers, ~std::uint32_t{0})) {
    for (int axis = 0; axis < Dim; ++axis) position_[axis] = hn::Set(integers, position[axis]);
  }

  /// The element at place p.
  template <class Layers>
  [[nodiscard]] static HWY_INLINE LayerProbe at(const Layers& layers, std::uint32_t p) {
    const std::int32_t position[3] = {layers.position[0][p], layers.position[1][p],
                                      Dim == 3 ? layers.position[2][p] : 0};
    return {layers, position, Reach(layers, p)};
  }

  /// The candidates that are certainly within reach; writes down the numbers of all.
  template <class Runs>
  HWY_INLINE Bits test(const Runs& runs, std::uint32_t* number) {
    Bits hits = 0;
    for (std::size_t k = 0; k < candidates; k += lanes) {
      const Floats beyond = hn::Sub(distance_squared(runs, k), reach_.inner(runs, k));
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
  [[nodiscard]] HWY_INLINE Bits hits(const Runs& runs, std::size_t k, Floats squares) const {
    const Mask is_hit = hn::Le(squares, reach_.outer(runs, k));
    if constexpr (Reach::counts_all) {
      return bits_of(is_hit);
    } else {
      return bits_of(hn::And(is_hit, hn::RebindMask(floats, reach_.counts(runs, k))));
    }
  }
  /// Those that certainly are.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Mask is_sure(const Runs& runs, std::size_t k, Floats squares) const {
    return hn::Lt(squares, reach_.inner(runs, k));
  }

  template <class Runs>
  [[nodiscard]] HWY_INLINE Floats distance_squared(const Runs& runs, std::size_t k) const {
    Floats sum = hn::Zero(floats);
    for (int axis = 0; axis < Dim; ++axis) {
      const Floats difference = hn::ConvertTo(
          floats, hn::Sub(runs.load(integers, layers_.position[axis], k), position_[axis]));
      const Floats square = hn::Mul(difference, difference);
      sum = axis == 0 ? square : hn::Add(sum, square);
    }
    return sum;
  }

 private:
  const LayerPair& layers_;
  Reach reach_;
  Numbers nearest_;
  Integers position_[Dim];
};
