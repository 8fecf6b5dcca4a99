#pragma once

#include "exact/box.hpp"
#include "exact/lattice.hpp"

#include <array>

namespace abut::exact {

/// The position of the image of box b that a shift names, relative to box a.
struct BoxGeometry {
  /// The vector from the center of a to that of b, each component rounded once.
  std::array<double, 3> vector{};

  /// Length of the real vector between the centers, off by at most one unit in the last place.
  double distance = 0.0;

  /// The unit vector along the axis of the largest separation, which the gap tells; of equal ones
  /// the first. It points to the side on which the center of b lies, and is 0 where that is
  /// neither.
  std::array<double, 3> normal{};

  /// Center of what the boxes have in common; on axes on which they are apart, the middle between
  /// them. Each component is rounded once.
  std::array<double, 3> point{};
};

/// Measures two boxes of any finite numbers. What exceeds the largest double becomes the largest.
template <int Dim>
[[nodiscard]] BoxGeometry geometry_of(const Box<Dim>& a, const Box<Dim>& b, const ImageShift& shift,
                                      const Lattice& lattice) noexcept;

}  // namespace abut::exact
