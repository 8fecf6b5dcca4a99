#pragma once

#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <array>

namespace abut::exact {

/// The vector between the centers of two elements, and its length.
struct DistanceVector {
  /// x_b + n A - x_a, each component rounded once (to even); 0 on the third axis in 2D.
  /// Exchanging a and b and negating n negates it, to the bit but for zeros, which are positive.
  std::array<double, 3> vector{};

  /// The real distance to the nearest double, the smaller of two that are equally near: never more
  /// than a double that the distance does not exceed. Not computed from the rounded vector. Below
  /// 2^-1000 it may be off by the last place.
  double distance = 0.0;
};

/// Computes the distance vector of any finite numbers. Components and distances that overflow
/// become the largest double.
template <int Dim>
[[nodiscard]] DistanceVector distance_vector(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                             const ImageShift& shift,
                                             const Lattice& lattice) noexcept;

}  // namespace abut::exact
