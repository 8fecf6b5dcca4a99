#include "exact/box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace abut::exact {

/// The part that rounding took away, from the operand of larger magnitude (T. J. Dekker, A
/// Floating-Point Technique for Extending the Available Precision, Numer. Math. 18, 1971, p. 224,
/// section 4): no step of it rounds, nor can it overflow.
bool difference_rounds_up(double a, double b, double rounded) noexcept {
  double large = a;
  double small = -b;
  if (std::fabs(large) < std::fabs(small)) std::swap(large, small);
  const double lost = small - (rounded - large);
  return lost <= 0.0;
}

template <int Dim>
double gap(const Box<Dim>& a, const Box<Dim>& b) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  double result = -largest;
  for (int axis = 0; axis < Dim; ++axis) {
    result = std::max({result, a.lower[axis] - b.upper[axis], b.lower[axis] - a.upper[axis]});
  }
  // Adding 0 makes -0 a 0: max may return either of two zeros.
  return std::min(result, largest) + 0.0;
}

template double gap(const Box<2>&, const Box<2>&) noexcept;
template double gap(const Box<3>&, const Box<3>&) noexcept;

}  // namespace abut::exact
