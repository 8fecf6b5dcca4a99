#pragma once

#include "exact/box.hpp"
#include "exact/sphere.hpp"
#include "lattice/reduced_lattice.hpp"

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

// WHY NO IMAGE IS MISSED. Let d be the difference of the centers, g_k the dual vectors as computed,
// D_k their length, t_k = g_k . d. For an image m within reach, v = d - sum m_l b_l is a vector no
// longer than some R, and
//   |t_k - m_k| <= |g_k . v| + sum |m_l| |g_k . b_l - (1 or 0)|,
// where the last factor is below 2^-46 D_k |b_l| (grid::ReducedLattice). As |b_l| D_l <= 2 and
// |m_l| <= (|d| + R) D_l but for the same error, the sum is below 2^-43 (|d| + R) D_k. Rounding in
// d and t_k is below 2^-50 (|d| + R) D_k. The window takes 2^-40 of all these, and of one for
// numbers below the normal range.
//
// Of spheres R is the reach, and |g_k . v| <= R D_k. Of boxes each component of v is at most R_l,
// half of both widths and the margin; |g_k . v| is at most the sum of |g_kl| R_l, and R that of
// the R_l. Along axes that no vector leads along, nothing counts.
constexpr double window_slack = 0x1p-40;

/// Farther out than any image shift can be; windows end there.
constexpr double farthest_number = 0x1p40;

[[nodiscard]] inline double cut(double number) noexcept {
  return number >= -farthest_number ? std::min(number, farthest_number) : -farthest_number;
}

/// What an image window is made of, times the lattice's scale, in halves because sums and
/// differences of the largest numbers overflow.
template <int Dim>
struct HalfDifference {
  double center[Dim] = {};  ///< of a less that of b
  double span = 0.0;        ///< |d| + R, at least
};

/// Whether some vector does.
template <int Dim>
[[nodiscard]] bool leads_along(const grid::ReducedLattice<Dim>& lattice, int axis) noexcept {
  for (std::size_t k = 0; k < lattice.count; ++k) {
    if (lattice.dual[k][static_cast<std::size_t>(axis)] != 0.0) return true;
  }
  return false;
}

/// half_bound(k) is half of a bound of |g_k . v|.
template <int Dim, class HalfBound>
[[nodiscard]] ImageWindow image_window(const grid::ReducedLattice<Dim>& lattice,
                                       const HalfDifference<Dim>& difference,
                                       HalfBound&& half_bound) noexcept {
  ImageWindow window;
  for (std::size_t k = 0; k < lattice.count; ++k) {
    double number = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      number += 2.0 * lattice.dual[k][axis] * difference.center[axis];
    }
    const double rounding = lattice.dual_length[k] * (window_slack * difference.span);
    const double width = 2.0 * (half_bound(k) + rounding) + window_slack;
    window.first[k] = static_cast<std::int64_t>(std::ceil(cut(number - width)));
    window.last[k] = static_cast<std::int64_t>(std::floor(cut(number + width)));
  }
  return window;
}

/// The window of b's images around a.
template <int Dim>
[[nodiscard]] ImageWindow image_window(const grid::ReducedLattice<Dim>& lattice,
                                       const base::Sphere<Dim>& a, const base::Sphere<Dim>& b,
                                       double margin) noexcept {
  const double half_reach = (0.5 * a.radius + 0.5 * b.radius + 0.5 * margin) * lattice.scale;
  HalfDifference<Dim> difference;
  difference.span = half_reach;
  for (int axis = 0; axis < Dim; ++axis) {
    if (!leads_along(lattice, axis)) continue;
    difference.center[axis] = (0.5 * a.center[axis] - 0.5 * b.center[axis]) * lattice.scale;
    difference.span += std::fabs(difference.center[axis]);
  }
  return image_window(lattice, difference,
                      [&](std::size_t k) { return lattice.dual_length[k] * half_reach; });
}

/// The same of boxes.
template <int Dim>
[[nodiscard]] ImageWindow image_window(const grid::ReducedLattice<Dim>& lattice,
                                       const base::Box<Dim>& a, const base::Box<Dim>& b,
                                       double margin) noexcept {
  HalfDifference<Dim> difference;
  double half_reach[Dim] = {};
  for (int axis = 0; axis < Dim; ++axis) {
    if (!leads_along(lattice, axis)) continue;
    const double half_of_a = (0.5 * a.upper[axis] - 0.5 * a.lower[axis]) * lattice.scale;
    const double half_of_b = (0.5 * b.upper[axis] - 0.5 * b.lower[axis]) * lattice.scale;
    half_reach[axis] = 0.5 * half_of_a + 0.5 * half_of_b + 0.5 * margin * lattice.scale;
    difference.center[axis] = (0.5 * a.lower[axis] - 0.5 * b.lower[axis]) * lattice.scale +
                              (0.5 * half_of_a - 0.5 * half_of_b);
    difference.span += half_reach[axis] + std::fabs(difference.center[axis]);
  }
  return image_window(lattice, difference, [&](std::size_t k) {
    double bound = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      bound += std::fabs(lattice.dual[k][axis]) * half_reach[axis];
    }
    return bound;
  });
}

}  // namespace abut::reference
