// Sums, products and quotients of pairs high + low, one pair a lane: the operations of
// exact/numbers/double_double_arithmetic.hpp in the same order, hence the same bits where no error
// of a product underflows. Included behind simd_center_line-inl.hpp.

/// exact::sum_of_ordered.
HWY_INLINE DoubleDoubleLanes sum_of_ordered(Doubles a, Doubles b) {
  const Doubles high = hn::Add(a, b);
  return {high, hn::Sub(b, hn::Sub(high, a))};
}

/// exact::sum.
HWY_INLINE DoubleDoubleLanes sum(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
  const DoubleDoubleLanes high = two_sum(a.high, b.high);
  return sum_of_ordered(high.high, hn::Add(high.low, hn::Add(a.low, b.low)));
}

/// exact::difference.
HWY_INLINE DoubleDoubleLanes difference(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
  return sum(a, {hn::Neg(b.high), hn::Neg(b.low)});
}

/// exact::product.
HWY_INLINE DoubleDoubleLanes product(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
  const DoubleDoubleLanes high = two_product(a.high, b.high);
  const Doubles crossed = hn::Add(hn::Mul(a.high, b.low), hn::Mul(a.low, b.high));
  return sum_of_ordered(high.high, hn::Add(high.low, crossed));
}

/// exact::quotient.
HWY_INLINE DoubleDoubleLanes quotient(const DoubleDoubleLanes& a, const DoubleDoubleLanes& b) {
  const Doubles first = hn::Div(a.high, b.high);
  const DoubleDoubleLanes back = two_product(first, b.high);
  const Doubles left =
      hn::Add(hn::Sub(hn::Sub(a.high, back.high), back.low), hn::Sub(a.low, hn::Mul(first, b.low)));
  return sum_of_ordered(first, hn::Div(left, b.high));
}

/// exact::DoubleDoubleVector.
struct VectorLanes {
  HWY_INLINE VectorLanes() {}

  DoubleDoubleLanes component[3];
};

/// exact::cross.
HWY_INLINE VectorLanes cross(const VectorLanes& a, const VectorLanes& b) {
  VectorLanes result;
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    result.component[axis] = difference(product(a.component[next], b.component[last]),
                                        product(a.component[last], b.component[next]));
  }
  return result;
}

/// exact::dot.
HWY_INLINE DoubleDoubleLanes dot(const VectorLanes& a, const VectorLanes& b) {
  return sum(sum(product(a.component[0], b.component[0]), product(a.component[1], b.component[1])),
             product(a.component[2], b.component[2]));
}
