// Coordinates x + n A become whole numbers over a common power of two, as those of orientation.cpp
// do. A move is as many bits longer than its lattice vectors as its numbers have.

#include "exact/simplices/moved_orientation.hpp"

#include "exact/integer_vector.hpp"
#include "exact/numbers/big_integer.hpp"
#include "exact/numbers/bit_range.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/numbers/small_integer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>

namespace abut::exact {
namespace {

/// The coordinates of some points as whole numbers: over which power of two, and how wide they may
/// become.
struct IntegerScale {
  int exponent;
  int bits;
};

/// x and at most three products n A of numbers of the range: below 2^(bits + width of n + 2).
template <int Dim>
IntegerScale scale_of(std::initializer_list<const MovedPoint<Dim>*> points) noexcept {
  BitRange range;
  int widest = 0;
  for (const MovedPoint<Dim>* point : points) {
    for (const double x : point->given) range.include(x);
    if (!point->is_moved) continue;
    for (const auto& step : point->move->steps) {
      for (const std::size_t axis : point->axes) range.include(step.vector[axis]);
      const auto number = static_cast<std::uint64_t>(std::llabs(std::int64_t{step.number}));
      widest = std::max(widest, static_cast<int>(std::bit_width(number)));
    }
  }
  return {range.lowest(), range.bits() + widest + 2};
}

template <class Integer, int Dim>
Integer coordinate(const MovedPoint<Dim>& point, std::size_t axis, int exponent) noexcept {
  Integer sum(point.given[axis], exponent);
  if (!point.is_moved) return sum;
  for (const auto& step : point.move->steps) {
    sum = sum + Integer(step.number, 0) * Integer(step.vector[point.axes[axis]], exponent);
  }
  return sum;
}

template <class Integer>
int sign_of_area(const MovedPoint<2>& a, const MovedPoint<2>& b, const MovedPoint<2>& c,
                 int exponent) noexcept {
  const Integer x = coordinate<Integer>(a, 0, exponent);
  const Integer y = coordinate<Integer>(a, 1, exponent);
  const Integer left =
      (coordinate<Integer>(b, 0, exponent) - x) * (coordinate<Integer>(c, 1, exponent) - y);
  const Integer right =
      (coordinate<Integer>(b, 1, exponent) - y) * (coordinate<Integer>(c, 0, exponent) - x);
  return (left - right).sign();
}

template <class Integer>
IntegerVector<Integer> vector_of(const MovedPoint<3>& p, int exponent) noexcept {
  return {coordinate<Integer>(p, 0, exponent), coordinate<Integer>(p, 1, exponent),
          coordinate<Integer>(p, 2, exponent)};
}

template <class Integer>
int sign_of_volume(const MovedPoint<3>& a, const MovedPoint<3>& b, const MovedPoint<3>& c,
                   const MovedPoint<3>& d, int exponent) noexcept {
  const IntegerVector<Integer> origin = vector_of<Integer>(a, exponent);
  const IntegerVector<Integer> normal =
      cross(vector_of<Integer>(b, exponent) - origin, vector_of<Integer>(c, exponent) - origin);
  return dot(normal, vector_of<Integer>(d, exponent) - origin).sign();
}

}  // namespace

int orientation_exactly(const MovedPoint<2>& a, const MovedPoint<2>& b,
                        const MovedPoint<2>& c) noexcept {
  const IntegerScale scale = scale_of({&a, &b, &c});
  return scale.bits <= most_short_bits_of_area ? sign_of_area<SmallInteger>(a, b, c, scale.exponent)
                                               : sign_of_area<BigInteger>(a, b, c, scale.exponent);
}

int orientation_exactly(const MovedPoint<3>& a, const MovedPoint<3>& b, const MovedPoint<3>& c,
                        const MovedPoint<3>& d) noexcept {
  const IntegerScale scale = scale_of({&a, &b, &c, &d});
  return scale.bits <= most_short_bits_of_volume
             ? sign_of_volume<SmallInteger>(a, b, c, d, scale.exponent)
             : sign_of_volume<BigInteger>(a, b, c, d, scale.exponent);
}

template <int Dim>
int compare_along(std::size_t axis, const MovedPoint<Dim>& a, const MovedPoint<Dim>& b) noexcept {
  if (a.is_moved == b.is_moved) return compare_along(axis, a.given, b.given);
  const double computed = a.near[axis] - b.near[axis];
  if (std::fabs(computed) > 2.0 * a.move->error) return computed < 0.0 ? -1 : 1;
  ExactAccumulator<1> sum;
  sum.add(a.given[axis], 1);
  sum.add(b.given[axis], -1);
  const MovedPoint<Dim>& moved = a.is_moved ? a : b;
  for (const auto& step : moved.move->steps) {
    sum.add(step.vector[moved.axes[axis]], a.is_moved ? step.number : -std::int64_t{step.number});
  }
  return sum.sign();
}

template <int Dim>
bool MovedPoint<Dim>::operator==(const MovedPoint& other) const noexcept {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    if (compare_along(axis, *this, other) != 0) return false;
  }
  return true;
}

template int compare_along(std::size_t, const MovedPoint<2>&, const MovedPoint<2>&) noexcept;
template int compare_along(std::size_t, const MovedPoint<3>&, const MovedPoint<3>&) noexcept;
template bool MovedPoint<2>::operator==(const MovedPoint<2>&) const noexcept;
template bool MovedPoint<3>::operator==(const MovedPoint<3>&) const noexcept;

}  // namespace abut::exact
