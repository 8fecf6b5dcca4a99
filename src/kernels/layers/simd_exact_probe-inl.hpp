// One element in all lanes, and the distances of its candidates where these are exact, included
// like simd_joined_runs-inl.hpp.

/// As LayerProbe, of elements of one radius whose positions are exact: a square of a distance is
/// compared as a whole number, and none is left undecided. Only lanes of the runs count: squares of
/// what lies behind these may overflow.
template <int Dim>
class ExactProbe {
 public:
  HWY_INLINE ExactProbe(const LayerPair& layers, std::uint32_t p)
      : layers_(layers), beyond_(hn::Set(integers, layers.largest_square + 1)) {
    for (int axis = 0; axis < Dim; ++axis) {
      position_[axis] = hn::Set(integers, layers.position[axis][p]);
    }
  }

  /// The element at place p.
  [[nodiscard]] static HWY_INLINE ExactProbe at(const LayerPair& layers, std::uint32_t p) {
    return {layers, p};
  }

  /// The candidates within reach, if there are no more than fit; writes down the numbers of all.
  template <class Runs>
  HWY_INLINE Bits test(const Runs& runs, std::uint32_t* number) const {
    Bits within = 0;
    for (std::size_t k = 0; k < candidates; k += lanes) {
      within |= hits(runs, k, distance(runs, k)) << k;
      hn::StoreU(runs.load(numbers, layers_.number, k), numbers, number + k);
    }
    return within & ((Bits{1} << std::min(runs.size(), candidates)) - 1);
  }

  [[nodiscard]] HWY_INLINE bool is_decided(Numbers) const { return true; }

  /// The candidates from lane k on that are within reach.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Bits hits(const Runs&, std::size_t, Integers squares) const {
    return bits_of(hn::RebindMask(floats, hn::Lt(squares, beyond_)));
  }
  template <class Runs>
  [[nodiscard]] HWY_INLINE Mask is_sure(const Runs&, std::size_t, Integers squares) const {
    return hn::RebindMask(floats, hn::Eq(squares, squares));
  }

  /// The squares of distances.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Integers distance(const Runs& runs, std::size_t k) const {
    Integers sum = hn::Zero(integers);
    for (int axis = 0; axis < Dim; ++axis) {
      const Integers difference =
          hn::Sub(runs.load(integers, layers_.position[axis], k), position_[axis]);
      const Integers square = hn::Mul(difference, difference);
      sum = axis == 0 ? square : hn::Add(sum, square);
    }
    return sum;
  }

 private:
  const LayerPair& layers_;
  Integers beyond_;
  Integers position_[Dim];
};
