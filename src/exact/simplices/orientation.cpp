// All coordinates become whole numbers over a common power of two. Short ones, such as those of a
// grid, fit into 128 bits with all that is made of them.

#include "exact/simplices/orientation.hpp"

#include "exact/integer_vector.hpp"
#include "exact/numbers/big_integer.hpp"
#include "exact/numbers/bit_range.hpp"
#include "exact/numbers/small_integer.hpp"

#include <initializer_list>

namespace abut::exact {
namespace {

template <class Point>
BitRange range_of(std::initializer_list<const Point*> points) noexcept {
  BitRange range;
  for (const Point* point : points) {
    for (const double x : *point) range.include(x);
  }
  return range;
}

template <class Integer>
int sign_of_area(const Point<2>& a, const Point<2>& b, const Point<2>& c, int exponent) noexcept {
  const Integer x(a[0], exponent);
  const Integer y(a[1], exponent);
  const Integer left = (Integer(b[0], exponent) - x) * (Integer(c[1], exponent) - y);
  const Integer right = (Integer(b[1], exponent) - y) * (Integer(c[0], exponent) - x);
  return (left - right).sign();
}

template <class Integer>
IntegerVector<Integer> vector_of(const Point<3>& p, int exponent) noexcept {
  return {Integer(p[0], exponent), Integer(p[1], exponent), Integer(p[2], exponent)};
}

template <class Integer>
int sign_of_volume(const Point<3>& a, const Point<3>& b, const Point<3>& c, const Point<3>& d,
                   int exponent) noexcept {
  const IntegerVector<Integer> origin = vector_of<Integer>(a, exponent);
  const IntegerVector<Integer> normal =
      cross(vector_of<Integer>(b, exponent) - origin, vector_of<Integer>(c, exponent) - origin);
  return dot(normal, vector_of<Integer>(d, exponent) - origin).sign();
}

}  // namespace

int orientation_exactly(const Point<2>& a, const Point<2>& b, const Point<2>& c) noexcept {
  const BitRange range = range_of({&a, &b, &c});
  return range.bits() <= most_short_bits_of_area
             ? sign_of_area<SmallInteger>(a, b, c, range.lowest())
             : sign_of_area<BigInteger>(a, b, c, range.lowest());
}

int orientation_exactly(const Point<3>& a, const Point<3>& b, const Point<3>& c,
                        const Point<3>& d) noexcept {
  const BitRange range = range_of({&a, &b, &c, &d});
  return range.bits() <= most_short_bits_of_volume
             ? sign_of_volume<SmallInteger>(a, b, c, d, range.lowest())
             : sign_of_volume<BigInteger>(a, b, c, d, range.lowest());
}

}  // namespace abut::exact
