#pragma once

#include <array>
#include <cstddef>

namespace abut::lattice {

/// Computes a . b in the order of the axes, each product and sum rounded.
template <int Dim>
[[nodiscard]] double dot(const std::array<double, Dim>& p,
                         const std::array<double, Dim>& q) noexcept {
  double sum = p[0] * q[0];
  for (std::size_t axis = 1; axis < Dim; ++axis) sum += p[axis] * q[axis];
  return sum;
}

}  // namespace abut::lattice
