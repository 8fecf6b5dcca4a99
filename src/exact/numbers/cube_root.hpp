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

/// The Dim-th root.
template <int Dim>
[[nodiscard]] double root(double x) noexcept {
  return Dim == 2 ? std::sqrt(x) : cube_root(x);
}

}  // namespace abut::exact
