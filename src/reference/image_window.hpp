#pragma once

#include "base/sphere_predicate.hpp"
#include "grid/reduced_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::reference {

/// The numbers of basis vectors that may bring an image within reach: a block of whole numbers,
/// ends included; (0, 0, 0) alone where nothing is periodic.
struct ImageWindow {
  grid::ImageNumbers first{};
  grid::ImageNumbers last{};

  [[nodiscard]] bool is_empty() const noexcept {
    return first[0] > last[0] || first[1] > last[1] || first[2] > last[2];
  }
};

template <class Body>
void for_each_image(const ImageWindow& window, Body&& body) {
  grid::ImageNumbers m{};
  for (m[0] = window.first[0]; m[0] <= window.last[0]; ++m[0]) {
    for (m[1] = window.first[1]; m[1] <= window.last[1]; ++m[1]) {
      for (m[2] = window.first[2]; m[2] <= window.last[2]; ++m[2]) body(m);
    }
  }
}

// WHY NO IMAGE IS MISSED. Let d = x_a - x_b, R the reach, g_k the dual vectors as computed, D_k
// their length, t_k = g_k . d. An image m within reach has |d - sum m_l b_l| <= R, so
//   |t_k - m_k| <= R D_k + sum |m_l| |g_k . b_l - (1 or 0)|,
// where the last factor is below 2^-46 D_k |b_l| (grid::ReducedLattice). As |b_l| D_l <= 2 and
// |m_l| <= (|d| + R) D_l but for the same error, the sum is below 2^-43 (|d| + R) D_k. Rounding in
// d and t_k is below 2^-50 |d| D_k. The window takes 2^-40 of all these, and of one for numbers
// below the normal range.
constexpr double window_slack = 0x1p-40;

/// Farther out than any image shift can be; windows end there.
constexpr double farthest_number = 0x1p40;

[[nodiscard]] inline double cut(double number) noexcept {
  return number >= -farthest_number ? std::min(number, farthest_number) : -farthest_number;
}

/// The window of b's images around a.
template <int Dim>
[[nodiscard]] ImageWindow image_window(const grid::ReducedLattice<Dim>& lattice,
                                       const base::Sphere<Dim>& a, const base::Sphere<Dim>& b,
                                       double margin) noexcept {
  // Halves, because sums and differences of the largest numbers overflow.
  const double half_reach = (0.5 * a.radius + 0.5 * b.radius + 0.5 * margin) * lattice.scale;
  double half_difference[Dim];
  double half_span = half_reach;
  for (int axis = 0; axis < Dim; ++axis) {
    half_difference[axis] = (0.5 * a.center[axis] - 0.5 * b.center[axis]) * lattice.scale;
    half_span += std::fabs(half_difference[axis]);
  }
  ImageWindow window;
  for (std::size_t k = 0; k < lattice.count; ++k) {
    double number = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double dual = lattice.dual[k][axis];
      if (dual != 0.0) number += 2.0 * dual * half_difference[axis];
    }
    const double width =
        2.0 * lattice.dual_length[k] * (half_reach + window_slack * half_span) + window_slack;
    window.first[k] = static_cast<std::int64_t>(std::ceil(cut(number - width)));
    window.last[k] = static_cast<std::int64_t>(std::floor(cut(number + width)));
  }
  return window;
}

}  // namespace abut::reference
