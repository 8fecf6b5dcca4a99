#pragma once

#include "exact/features/triangle_predicate.hpp"

#include <cstddef>
#include <optional>

namespace abut::exact {

/// The corners at the ends of a side.
struct SideEnds {
  std::size_t from;
  std::size_t to;
};

[[nodiscard]] constexpr SideEnds ends_of(TrianglePart side) noexcept {
  switch (side) {
    case TrianglePart::side_01:
      return {0, 1};
    case TrianglePart::side_02:
      return {0, 2};
    default:
      return {1, 2};
  }
}

/// Finds the part of a triangle that holds the point nearest to the center, by signs alone. With p,
/// q, r the corners seen from the center and n the vector product of 01 and 02,
///
///   signs.along(p, q)  is that of (q - p) · p,     -1, 0 or 1
///   signs.turn(p, q)   that of n · (p x q),        or nothing if it is not known.
///
/// A point m of a convex set is the nearest if and only if (x - m) · m >= 0 for all x of the set,
/// which need be asked of corners only. At m = p that is along(p, q) >= 0 and along(p, r) >= 0. On
/// a side pq the nearest point of its line lies between the ends if along(p, q) < 0 and along(q, p)
/// < 0, and there (r - m) · m has the sign of -n · (p x q), the corners pqr in cyclic order. What
/// is neither at a corner nor on a side is in the face; all sums and products hold for triangles
/// without area, too. (C. Ericson, Real-Time Collision Detection, 2005, section 5.1.5, divides the
/// plane likewise.)
template <class Signs>
[[nodiscard]] std::optional<TrianglePart> nearest_part(const Signs& signs) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (signs.along(k, (k + 1) % 3) >= 0 && signs.along(k, (k + 2) % 3) >= 0) {
      return static_cast<TrianglePart>(k);
    }
  }
  for (const TrianglePart side :
       {TrianglePart::side_01, TrianglePart::side_02, TrianglePart::side_12}) {
    const auto [from, to] = ends_of(side);
    if (signs.along(from, to) >= 0 || signs.along(to, from) >= 0) continue;
    const std::optional<int> turn = signs.turn(from, to);
    if (!turn) return std::nullopt;
    const int inwards = side == TrianglePart::side_02 ? -*turn : *turn;
    if (inwards <= 0) return side;
  }
  return TrianglePart::face;
}

}  // namespace abut::exact
