// The line between the centers of two spheres, one pair a lane: the operations of exact::CenterLine
// where its numbers are ordinary, in the same order, hence the same bits. Included behind
// simd_spheres-inl.hpp.

/// Largest error of the sum of the terms of a shifted difference, relative to the largest number of
/// the pair (docs/derivations/contact_geometry.md, section 2).
constexpr double error_of_sum = 0x1p-96;

/// A hair above exact::smallest_ordinary, so that exact::gap does not scale either.
constexpr double smallest_measured = 4.0 * exact::smallest_ordinary;

/// exact::two_product.
HWY_INLINE DoubleDoubleLanes two_product(Doubles a, Doubles b) {
  const Doubles product = hn::Mul(a, b);
  return {product, error_of_product(a, b, product)};
}

/// exact::CompensatedSum, and what its low part loses.
struct CompensatedLanes {
  HWY_INLINE CompensatedLanes(const DoubleDoubleLanes& sum)
      : high(sum.high), low(sum.low), lost(hn::Zero(doubles)) {}

  HWY_INLINE void add(Doubles term) {
    const DoubleDoubleLanes sum = two_sum(high, term);
    high = sum.high;
    const DoubleDoubleLanes rest = two_sum(low, sum.low);
    low = rest.high;
    lost = hn::Or(lost, rest.low);
  }

  Doubles high;
  Doubles low;
  Doubles lost;  ///< a sign at most where the sum has no error
};

/// v = x_b + n A - x_a, and what is known of it.
template <int Dim>
struct LineLanes {
  HWY_INLINE LineLanes() {}

  DoubleDoubleLanes vector[Dim];
  Doubles error;  ///< of each component, at most
  Mask is_ordinary;
};

HWY_INLINE Doubles largest_of(Doubles a, Doubles b) {
  return hn::Max(hn::Abs(a), hn::Abs(b));
}

/// The numbers of a pair lie where exact::CenterLine scales nothing, and so do the components.
template <int Dim>
HWY_INLINE Mask ordinary(const LineLanes<Dim>& line, Doubles largest) {
  const Doubles most = hn::Set(doubles, exact::largest_ordinary);
  Mask ordinary = hn::Le(largest, most);
  Doubles longest = hn::Zero(doubles);
  for (const DoubleDoubleLanes& component : line.vector) {
    const Doubles magnitude = hn::Abs(component.high);
    const Mask is_zero = hn::Eq(magnitude, hn::Zero(doubles));
    const Mask fits =
        hn::And(hn::Ge(magnitude, hn::Set(doubles, smallest_measured)), hn::Le(magnitude, most));
    ordinary = hn::And(ordinary, hn::Or(is_zero, fits));
    longest = hn::Max(longest, magnitude);
  }
  // Coincident centers, and what lattice vectors cancel nearly, are left to exact::CenterLine.
  ordinary = hn::And(ordinary, hn::Gt(longest, hn::Zero(doubles)));
  const Doubles least = hn::Mul(hn::Set(doubles, exact::most_cancellation), largest);
  const Mask is_moved = hn::Gt(line.error, hn::Zero(doubles));
  return hn::AndNot(hn::And(is_moved, hn::Lt(longest, least)), ordinary);
}

template <int Dim>
HWY_INLINE LineLanes<Dim> line_between(const Spheres<Dim>& a, const Spheres<Dim>& b) {
  LineLanes<Dim> line;
  Doubles largest = hn::Max(a.radius, b.radius);
  for (int axis = 0; axis < Dim; ++axis) {
    largest = hn::Max(largest, largest_of(a.center[axis], b.center[axis]));
    line.vector[axis] = two_sum(b.center[axis], hn::Neg(a.center[axis]));
  }
  line.error = hn::Zero(doubles);
  line.is_ordinary = ordinary(line, largest);
  return line;
}

/// `numbers[k]`: how many vectors k of the lattice each lane is moved.
template <int Dim>
HWY_INLINE LineLanes<Dim> moved_line_between(const Spheres<Dim>& a, const Spheres<Dim>& b,
                                             const Doubles (&numbers)[3],
                                             const double (*lattice)[3]) {
  LineLanes<Dim> line;
  Doubles lost = hn::Zero(doubles);
  Doubles largest = hn::Max(a.radius, b.radius);
  for (int axis = 0; axis < Dim; ++axis) {
    largest = hn::Max(largest, largest_of(a.center[axis], b.center[axis]));
    CompensatedLanes difference(two_sum(a.center[axis], hn::Neg(b.center[axis])));
    for (int k = 0; k < Dim; ++k) {
      if (lattice[k][axis] == 0.0) continue;
      const Doubles number = hn::Neg(numbers[k]);
      const DoubleDoubleLanes term = two_product(number, hn::Set(doubles, lattice[k][axis]));
      largest = hn::Max(largest, hn::Abs(term.high));
      difference.add(term.high);
      // Mostly there is none: numbers are small.
      const Mask has_low = hn::Ne(term.low, hn::Zero(doubles));
      if (!hn::AllFalse(doubles, has_low)) difference.add(term.low);
    }
    const DoubleDoubleLanes sum = two_sum(difference.high, difference.low);
    line.vector[axis] = {hn::Neg(sum.high), hn::Neg(sum.low)};
    lost = hn::Or(lost, difference.lost);
  }
  line.error = hn::Mul(hn::Set(doubles, error_of_sum), largest);
  line.is_ordinary = ordinary(line, largest);
  // Numbers of like size lose no bit, but their sum is often in the middle of two doubles.
  const Mask is_exact = hn::Eq(hn::Abs(lost), hn::Zero(doubles));
  line.error = hn::IfThenZeroElse(is_exact, line.error);
  return line;
}

/// |v| = root + rest.
struct LengthLanes {
  HWY_INLINE LengthLanes() {}

  Doubles root;
  Doubles rest;
  Doubles inverse;  ///< of the root
};

template <int Dim>
HWY_INLINE LengthLanes length_of(const LineLanes<Dim>& line) {
  Doubles high = hn::Zero(doubles);
  Doubles low = hn::Zero(doubles);
  for (const DoubleDoubleLanes& component : line.vector) {
    const DoubleDoubleLanes term = square(component);
    const DoubleDoubleLanes sum = two_sum(high, term.high);
    high = sum.high;
    low = hn::Add(low, hn::Add(sum.low, term.low));
  }
  LengthLanes length;
  length.root = hn::Sqrt(high);
  length.inverse = hn::Div(hn::Set(doubles, 1.0), length.root);
  const DoubleDoubleLanes of_root = square({length.root, hn::Zero(doubles)});
  const Doubles excess = hn::Add(hn::Sub(hn::Sub(high, of_root.high), of_root.low), low);
  length.rest = hn::Mul(excess, hn::Mul(hn::Set(doubles, 0.5), length.inverse));
  return length;
}

/// v / |v| as pairs.
template <int Dim>
struct DirectionLanes {
  HWY_INLINE DirectionLanes() {}

  DoubleDoubleLanes unit[Dim];
};

template <int Dim>
HWY_INLINE DirectionLanes<Dim> direction_of(const LineLanes<Dim>& line, const LengthLanes& length) {
  DirectionLanes<Dim> direction;
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDoubleLanes& component = line.vector[axis];
    const Doubles quotient = hn::Mul(component.high, length.inverse);
    const DoubleDoubleLanes product = two_product(quotient, length.root);
    const Doubles left = hn::Add(hn::Sub(hn::Sub(component.high, product.high), product.low),
                                 hn::Sub(component.low, hn::Mul(quotient, length.rest)));
    direction.unit[axis] = {quotient, hn::Mul(left, length.inverse)};
  }
  return direction;
}

/// exact::point_on, where what the radii add underflows nowhere: other lanes leave `certain`.
HWY_INLINE Doubles point_on(Doubles start, const DoubleDoubleLanes& vector,
                            const DoubleDoubleLanes& unit, const DoubleDoubleLanes& radii,
                            Mask& certain) {
  const Doubles half = hn::Set(doubles, 0.5);
  const DoubleDoubleLanes middle = two_sum(start, hn::Mul(half, vector.high));
  const Doubles half_high = hn::Mul(half, radii.high);
  const DoubleDoubleLanes along = two_product(unit.high, half_high);
  const Doubles smaller_factor = hn::Min(hn::Abs(unit.high), hn::Abs(half_high));
  const Mask is_exact = hn::Or(hn::Ge(hn::Abs(along.high), hn::Set(doubles, smallest_measured)),
                               hn::Eq(smaller_factor, hn::Zero(doubles)));
  certain = hn::And(certain, is_exact);
  const Doubles along_low = hn::Add(along.low, hn::Add(hn::Mul(unit.high, hn::Mul(half, radii.low)),
                                                       hn::Mul(unit.low, half_high)));
  const DoubleDoubleLanes point = two_sum(middle.high, along.high);
  const Doubles middle_low = hn::Add(middle.low, hn::Mul(half, vector.low));
  return hn::Add(point.high, hn::Add(point.low, hn::Add(middle_low, along_low)));
}

// Sums, products and quotients of pairs: the operations of
// exact/numbers/double_double_arithmetic.hpp in the same order, hence the same bits where no error
// of a product underflows.

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
