#pragma once

#include <abut/element_view.hpp>

#include <utility>

namespace abut {

/// Views points in separate arrays: spheres of radius 0, for `neighbors` and as probes of another
/// set.
template <ColumnLike X, ColumnLike Y, ColumnLike Z>
[[nodiscard]] ElementView points(X&& x, Y&& y, Z&& z) {
  return spheres(std::forward<X>(x), std::forward<Y>(y), std::forward<Z>(z), 0.0);
}

/// Views points of the plane in separate arrays: discs of radius 0.
template <ColumnLike X, ColumnLike Y>
[[nodiscard]] ElementView points(X&& x, Y&& y) {
  return discs(std::forward<X>(x), std::forward<Y>(y), 0.0);
}

}  // namespace abut
