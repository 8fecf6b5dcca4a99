// Spheres of scattered pairs in lanes of doubles, and sums and squares in double-double arithmetic,
// included like simd_pair_tester-inl.hpp. Nothing is fused but a product and its negative, whose
// sum is the rounding error of the product: it is a double, so that both ways give the same bits.

/// Wider vectors would take longer to fill from scattered elements than to use.
using DoubleTag = hn::CappedTag<double, 4>;
using WordTag = hn::RebindToUnsigned<DoubleTag>;
using Doubles = hn::Vec<DoubleTag>;
using Mask = hn::Mask<DoubleTag>;
constexpr DoubleTag doubles{};
constexpr WordTag words{};
constexpr std::size_t lanes = hn::MaxLanes(DoubleTag());
static_assert(lanes <= 4);

/// One sphere a lane.
template <int Dim>
struct Spheres {
  // Written out: g++ makes the implied one without the instruction set of the namespace.
  HWY_INLINE Spheres() {}

  Doubles center[Dim];
  Doubles radius;
};

#if HWY_TARGET == HWY_SCALAR

/// Numbers k and k + 1 of each sphere.
HWY_INLINE void load_two(DoubleTag tag, const double* const* spheres, std::size_t k, Doubles& first,
                         Doubles& second) {
  first = hn::Set(tag, spheres[0][k]);
  second = hn::Set(tag, spheres[0][k + 1]);
}

#else

/// Numbers k and k + 1 of each sphere.
template <class Tag>
HWY_INLINE void load_two(Tag tag, const double* const* spheres, std::size_t k, Doubles& first,
                         Doubles& second) {
  const auto of = [&](std::size_t lane) {
    return hn::LoadU(hn::FixedTag<double, 2>(), spheres[lane] + k);
  };
  if constexpr (hn::MaxLanes(Tag()) == 2) {
    first = hn::InterleaveLower(tag, of(0), of(1));
    second = hn::InterleaveUpper(tag, of(0), of(1));
  } else {
    const auto even = hn::Combine(tag, of(2), of(0));
    const auto odd = hn::Combine(tag, of(3), of(1));
    first = hn::InterleaveLower(tag, even, odd);
    second = hn::InterleaveUpper(tag, even, odd);
  }
}

#endif

template <int Dim>
HWY_INLINE Spheres<Dim> load(const double* const* spheres) {
  Spheres<Dim> loaded;
  load_two(doubles, spheres, 0, loaded.center[0], loaded.center[1]);
  load_two(doubles, spheres, Dim - 1, loaded.center[Dim - 1], loaded.radius);
  return loaded;
}

/// high + low, exactly: exact::DoubleDouble.
struct DoubleDoubleLanes {
  // Written out, as that of Spheres.
  HWY_INLINE DoubleDoubleLanes() {}
  HWY_INLINE DoubleDoubleLanes(Doubles the_high, Doubles the_low) : high(the_high), low(the_low) {}

  Doubles high;
  Doubles low;
};

HWY_INLINE DoubleDoubleLanes two_sum(Doubles a, Doubles b) {
  const Doubles sum = hn::Add(a, b);
  const Doubles b_seen = hn::Sub(sum, a);
  return {sum, hn::Add(hn::Sub(a, hn::Sub(sum, b_seen)), hn::Sub(b, b_seen))};
}

/// The rounding error of `product` = a * b, where it is a double: not where it underflows.
HWY_INLINE Doubles error_of_product(Doubles a, Doubles b, Doubles product) {
#if HWY_NATIVE_FMA
  return hn::MulSub(a, b, product);
#else
  // By numbers of half the length: T. J. Dekker, 1971, as in exact::two_product.
  const Doubles splitter = hn::Set(doubles, 134217729.0);
  const Doubles scaled_a = hn::Mul(splitter, a);
  const Doubles a_high = hn::Sub(scaled_a, hn::Sub(scaled_a, a));
  const Doubles a_low = hn::Sub(a, a_high);
  const Doubles scaled_b = hn::Mul(splitter, b);
  const Doubles b_high = hn::Sub(scaled_b, hn::Sub(scaled_b, b));
  const Doubles b_low = hn::Sub(b, b_high);
  const Doubles crossed =
      hn::Add(hn::Add(hn::Sub(hn::Mul(a_high, b_high), product), hn::Mul(a_high, b_low)),
              hn::Mul(a_low, b_high));
  return hn::Add(crossed, hn::Mul(a_low, b_low));
#endif
}

/// exact::square and the exact::two_square in it.
HWY_INLINE DoubleDoubleLanes square(const DoubleDoubleLanes& value) {
  const Doubles square = hn::Mul(value.high, value.high);
  const Doubles low = error_of_product(value.high, value.high, square);
  return {square, hn::Add(low, hn::Mul(hn::Add(value.high, value.high), value.low))};
}
