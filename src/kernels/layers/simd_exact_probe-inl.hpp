// One element in all lanes, and the distances of its candidates where these are exact, included
// like simd_joined_runs-inl.hpp.

/// As LayerProbe, of elements of one radius whose positions are exact: a square of a distance is
/// compared as a whole number, and none is left undecided. Only lanes of the runs count: squares of
/// what lies behind these may overflow.
template <int Dim>
class ExactProbe {
 public:
  /// Squares of what is farther away might overflow.
  static constexpr bool is_right_beyond_runs = false;

  HWY_INLINE ExactProbe(const LayerPair& layers, std::uint32_t p)
      : layers_(layers), beyond_(layers.largest_square + 1) {
    for (int axis = 0; axis < Dim; ++axis) position_[axis] = layers.position[axis][p];
  }

  /// The element at place p.
  [[nodiscard]] static HWY_INLINE ExactProbe at(const LayerPair& layers, std::uint32_t p) {
    return {layers, p};
  }

  /// None is undecided.
  template <class Lanes>
  struct Nearest {
    [[nodiscard]] HWY_INLINE bool is_decided(float) const { return true; }
  };

  /// The candidates within reach, of runs that fit.
  template <class Runs, class Lanes>
  [[nodiscard]] HWY_INLINE Bits test(const Runs& runs, Nearest<Lanes>&) const {
    Bits within = 0;
    for (std::size_t k = 0; k < Runs::capacity; k += Runs::at_once) {
      within |= hits(runs, k, distance(runs, k)) << k;
    }
    return within & ((Bits{1} << std::min(runs.size(), Runs::capacity)) - 1);
  }

  /// The candidates from lane k on that are within reach.
  template <class Runs>
  [[nodiscard]] HWY_INLINE Bits hits(const Runs&, std::size_t,
                                     hn::Vec<typename Runs::IntegerTag> squares) const {
    const auto beyond = hn::Set(Runs::integers, beyond_);
    return bits_of(Runs::floats, hn::RebindMask(Runs::floats, hn::Lt(squares, beyond)));
  }
  template <class Runs>
  [[nodiscard]] HWY_INLINE Mask is_sure(const Runs&, std::size_t, Integers squares) const {
    return hn::RebindMask(floats, hn::Eq(squares, squares));
  }

  /// The squares of distances.
  template <class Runs>
  [[nodiscard]] HWY_INLINE auto distance(const Runs& runs, std::size_t k) const {
    auto sum = hn::Zero(Runs::integers);
    for (int axis = 0; axis < Dim; ++axis) {
      const auto difference = hn::Sub(runs.load(Runs::integers, layers_.position[axis], k),
                                      hn::Set(Runs::integers, position_[axis]));
      const auto square = hn::Mul(difference, difference);
      sum = axis == 0 ? square : hn::Add(sum, square);
    }
    return sum;
  }

 private:
  const LayerPair& layers_;
  std::int32_t beyond_;
  std::int32_t position_[Dim];
};
