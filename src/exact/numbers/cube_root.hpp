#pragma once

#include <algorithm>
#include <cmath>

namespace abut::exact {

/// The cube root by Newton's iteration from above: + - x / only, so that it has the same bits on
/// every machine, unlike std::cbrt. For x >= 0: that of 0 is 0, that of infinity is infinity.
[[nodiscard]] inline double cube_root(double x) noexcept {
  if (!(x > 0.0)) return x;  // no power of 8 is a scale for 0
  // x = m 8^k with 1 <= m < 8. The root of m is concave: it lies below its tangents, here at 1 and
  // at 4, and not more than a seventeenth.
  const int exponent = std::ilogb(x);
  const int k = (exponent < 0 ? exponent - 2 : exponent) / 3;
  const double m = std::ldexp(x, -3 * k);
  constexpr double root_of_4 = 1.5874010519682;  // rounded up
  const double tangent = std::min(1.0 + (m - 1.0) / 3.0, root_of_4 * (1.0 + (m - 4.0) / 12.0));
  double root = std::ldexp(tangent * (1.0 + 0x1p-50), k);
  while (true) {
    const double next = root - (root - x / (root * root)) * (1.0 / 3.0);
    if (!(next < root)) return root;
    root = next;
  }
}

/// The side of a cube, square or line of that volume, with the same bits everywhere, too.
[[nodiscard]] inline double side_of(double volume, int axes) noexcept {
  if (axes == 3) return cube_root(volume);
  return axes == 2 ? std::sqrt(volume) : volume;
}

/// The Dim-th root.
template <int Dim>
[[nodiscard]] double root(double x) noexcept {
  return side_of(x, Dim);
}

}  // namespace abut::exact
