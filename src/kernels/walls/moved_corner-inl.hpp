// Corners moved by lattice vectors, and the way there from a center, rounded as exact::component
// does where that is certain. Included behind simd_center_line-inl.hpp.
// docs/derivations/contact_geometry.md, section 6.

/// Bound of the error of `lowest`, and of what is added to bound it, relative to `lost`.
constexpr double error_of_lowest = 0x1p-48;

/// A number that exceeds `most` by so much in its last places does so after rounding, too.
constexpr double a_little_more = 1.0 + 0x1p-50;

/// A sum of doubles: high + low, exactly, and what the additions to `low` lost.
struct SumLanes {
  HWY_INLINE SumLanes(Doubles first)
      : high(first), low(hn::Zero(doubles)), lowest(hn::Zero(doubles)), lost(hn::Zero(doubles)) {}

  HWY_INLINE void add(Doubles term) {
    const DoubleDoubleLanes sum = two_sum(high, term);
    const DoubleDoubleLanes rest = two_sum(low, sum.low);
    high = sum.high;
    low = rest.high;
    lowest = hn::Add(lowest, rest.low);
    lost = hn::Add(lost, hn::Abs(rest.low));
  }

  Doubles high;
  Doubles low;
  Doubles lowest;  ///< the sum of what was lost, rounded
  Doubles lost;    ///< the sum of its magnitudes, rounded
};

/// Returns the nearest double, and the nearest to what it leaves: exact::component. Lanes where
/// that is not sure leave `certain`.
HWY_INLINE DoubleDoubleLanes rounded(const SumLanes& sum, Mask& certain) {
  DoubleDoubleLanes found = two_sum(sum.high, sum.low);
  const Mask is_all = hn::Eq(sum.lost, hn::Zero(doubles));
  if (HWY_LIKELY(hn::AllTrue(doubles, is_all))) return found;
  const Doubles error = hn::Mul(hn::Set(doubles, error_of_lowest), sum.lost);
  const Doubles least = hn::Add(found.low, hn::Sub(sum.lowest, error));
  const Doubles most = hn::Add(found.low, hn::Add(sum.lowest, error));
  const Doubles beyond = hn::Mul(most, hn::Set(doubles, a_little_more));
  const Mask is_sure =
      hn::And(hn::Eq(least, most), hn::Eq(hn::Add(found.high, beyond), found.high));
  certain = hn::And(certain, hn::Or(is_all, is_sure));
  found.low = least;
  return found;
}

/// Adds n A along an axis for the contacts from k on. Nothing underflows: a component of A is 0 or
/// at least smallest_given.
HWY_INLINE void add_moves(const FeatureMoves& moves, int axis, std::size_t k, SumLanes& sum) {
  const hn::Rebind<std::int32_t, DoubleTag> whole;
  for (int vector = 0; vector < 3; ++vector) {
    const double component = moves.lattice[vector][axis];
    if (component == 0.0) continue;
    const Doubles number = hn::PromoteTo(doubles, hn::LoadU(whole, moves.number[axis][vector] + k));
    const DoubleDoubleLanes term = two_product(number, hn::Set(doubles, component));
    sum.add(term.high);
    sum.add(term.low);
  }
}
