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
  const Doubles splitter = hn::Set(doubles, 134217729.0);
  const Doubles scaled_a = hn::Mul(splitter, a);
  const Doubles a_high = hn::Sub(scaled_a, hn::Sub(scaled_a, a));
  const Doubles a_low = hn::Sub(a, a_high);
  const Doubles scaled_b = hn::Mul(splitter, b);
  const Doubles b_high = hn::Sub(scaled_b, hn::Sub(scaled_b, b));
  const Doubles b_low = hn::Sub(b, b_high);
  const Doubles product = hn::Mul(a, b);
  const Doubles crossed =
      hn::Add(hn::Add(hn::Sub(hn::Mul(a_high, b_high), product), hn::Mul(a_high, b_low)),
              hn::Mul(a_low, b_high));
  return {product, hn::Add(crossed, hn::Mul(a_low, b_low))};
}

/// exact::CompensatedSum.
struct CompensatedLanes {
  HWY_INLINE CompensatedLanes(Doubles first) : high(first), low(hn::Zero(doubles)) {}

  HWY_INLINE void add(Doubles term) {
    const DoubleDoubleLanes sum = two_sum(high, term);
    high = sum.high;
    low = hn::Add(low, sum.low);
  }

  Doubles high;
  Doubles low;
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
                                             const double (*numbers)[lanes],
                                             const double (*lattice)[3]) {
  LineLanes<Dim> line;
  Doubles largest = hn::Max(a.radius, b.radius);
  for (int axis = 0; axis < Dim; ++axis) {
    largest = hn::Max(largest, largest_of(a.center[axis], b.center[axis]));
    CompensatedLanes difference(a.center[axis]);
    difference.add(hn::Neg(b.center[axis]));
    for (int k = 0; k < Dim; ++k) {
      if (lattice[k][axis] == 0.0) continue;
      const Doubles number = hn::Neg(hn::LoadU(doubles, numbers[k]));
      const DoubleDoubleLanes term = two_product(number, hn::Set(doubles, lattice[k][axis]));
      largest = hn::Max(largest, hn::Abs(term.high));
      difference.add(term.high);
      difference.add(term.low);
    }
    const DoubleDoubleLanes sum = two_sum(difference.high, difference.low);
    line.vector[axis] = {hn::Neg(sum.high), hn::Neg(sum.low)};
  }
  line.error = hn::Mul(hn::Set(doubles, error_of_sum), largest);
  line.is_ordinary = ordinary(line, largest);
  return line;
}

/// |v| = root + rest, and v / |v| as pairs.
template <int Dim>
struct DirectionLanes {
  HWY_INLINE DirectionLanes() {}

  Doubles root;
  Doubles rest;
  DoubleDoubleLanes unit[Dim];
};

template <int Dim>
HWY_INLINE DirectionLanes<Dim> direction_of(const LineLanes<Dim>& line) {
  DirectionLanes<Dim> direction;
  Doubles high = hn::Zero(doubles);
  Doubles low = hn::Zero(doubles);
  for (const DoubleDoubleLanes& component : line.vector) {
    const DoubleDoubleLanes term = square(component);
    const DoubleDoubleLanes sum = two_sum(high, term.high);
    high = sum.high;
    low = hn::Add(low, hn::Add(sum.low, term.low));
  }
  const Doubles root = hn::Sqrt(high);
  const Doubles inverse = hn::Div(hn::Set(doubles, 1.0), root);
  const DoubleDoubleLanes of_root = square({root, hn::Zero(doubles)});
  const Doubles excess = hn::Add(hn::Sub(hn::Sub(high, of_root.high), of_root.low), low);
  direction.root = root;
  direction.rest = hn::Mul(excess, hn::Mul(hn::Set(doubles, 0.5), inverse));
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDoubleLanes& component = line.vector[axis];
    const Doubles quotient = hn::Mul(component.high, inverse);
    const DoubleDoubleLanes product = two_product(quotient, root);
    const Doubles left = hn::Add(hn::Sub(hn::Sub(component.high, product.high), product.low),
                                 hn::Sub(component.low, hn::Mul(quotient, direction.rest)));
    direction.unit[axis] = {quotient, hn::Mul(left, inverse)};
  }
  return direction;
}

/// exact::point_on.
HWY_INLINE Doubles point_on(Doubles start, const DoubleDoubleLanes& vector,
                            const DoubleDoubleLanes& unit, const DoubleDoubleLanes& radii) {
  const Doubles half = hn::Set(doubles, 0.5);
  const DoubleDoubleLanes middle = two_sum(start, hn::Mul(half, vector.high));
  const Doubles half_high = hn::Mul(half, radii.high);
  const DoubleDoubleLanes along = two_product(unit.high, half_high);
  const Doubles along_low = hn::Add(along.low, hn::Add(hn::Mul(unit.high, hn::Mul(half, radii.low)),
                                                       hn::Mul(unit.low, half_high)));
  const DoubleDoubleLanes point = two_sum(middle.high, along.high);
  const Doubles middle_low = hn::Add(middle.low, hn::Mul(half, vector.low));
  return hn::Add(point.high, hn::Add(point.low, hn::Add(middle_low, along_low)));
}
