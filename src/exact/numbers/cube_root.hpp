#pragma once

#include <cmath>

namespace abut::exact {

/// The cube root by Newton's iteration from above: + - x / only, so that it has the same bits on
/// every machine, unlike std::cbrt. For finite x > 0.
[[nodiscard]] inline double cube_root(double x) noexcept {
  // 2^(ceil(e / 3) + 1) >= the root.
  double root = std::ldexp(1.0, std::ilogb(x) / 3 + 2);
  while (true) {
    const double next = root - (root - x / root / root) / 3.0;
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
