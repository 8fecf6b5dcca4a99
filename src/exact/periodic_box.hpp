#pragma once

#include "base/host_device.hpp"
#include "exact/box.hpp"
#include "exact/lattice.hpp"

#include <cmath>
#include <cstdint>

namespace abut::exact {

/// The slow path: the contract for boxes in real arithmetic, for every finite double and every
/// shift n of a lattice A.
template <int Dim>
[[nodiscard]] ABUT_HD bool within_reach_exactly(const Box<Dim>& a, const Box<Dim>& b,
                                                const LatticeSteps<Dim>& steps,
                                                double margin) noexcept;

// THE BAND IS ABSOLUTE, as that of spheres is (periodic_predicate.hpp). On one axis t = n A is
// a sum of at most three products, and lo_a - hi_b - t - margin takes three more subtractions; so
// does lo_b - hi_a + t - margin. With m the sum of the magnitudes of all that is added up, u =
// 2^-53, each of at most five additions is off by u m (1 + 6 u), and the products together by u m:
// less than 6.1 u m. The band of 8 u m is more than 7.99 u m as computed. Inside [2^-900, 2^1000]
// nothing overflows, and the band is a normal number; sums and products lose nothing by underflow.
// docs/derivations/periodic_predicate.md tells it at length.
inline constexpr double box_band = 0x1p-50;  // 8 u
inline constexpr double smallest_safe_box_magnitude = 0x1p-900;
inline constexpr double largest_safe_box_magnitude = 0x1p1000;

/// The contract with a lattice: whether a and the image of b that `shift` names are within reach.
/// Touching counts. Adds at most one to `exact_decisions`: for pairs that doubles cannot decide, or
/// that an axis on which nothing moves leaves in doubt.
template <int Dim>
[[nodiscard]] ABUT_HD inline bool within_reach(const Box<Dim>& a, const Box<Dim>& b,
                                               const ImageShift& shift, const Lattice& lattice,
                                               double margin,
                                               std::uint64_t& exact_decisions) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  bool in_doubt = false;
  std::uint64_t looked_at_again = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    double moved = 0.0;
    double magnitude = 0.0;
    for (const auto& step : steps) {
      const double product = step.number * step.vector[axis];
      moved += product;
      magnitude += std::fabs(product);
    }
    if (magnitude == 0.0) {  // b stays where it is on this axis
      if (!at_most(a.lower[axis], b.upper[axis], margin, looked_at_again) ||
          !at_most(b.lower[axis], a.upper[axis], margin, looked_at_again)) {
        return false;
      }
      continue;
    }
    magnitude += std::fabs(a.lower[axis]) + std::fabs(a.upper[axis]) + std::fabs(b.lower[axis]) +
                 std::fabs(b.upper[axis]) + margin;
    if (!(magnitude >= smallest_safe_box_magnitude && magnitude <= largest_safe_box_magnitude)) {
      in_doubt = true;
      continue;
    }
    const double slack = box_band * magnitude;
    const double a_behind_b = ((a.lower[axis] - b.upper[axis]) - moved) - margin;
    const double b_behind_a = ((b.lower[axis] - a.upper[axis]) + moved) - margin;
    if (a_behind_b > slack || b_behind_a > slack) return false;
    in_doubt = in_doubt || !(a_behind_b < -slack && b_behind_a < -slack);
  }
  exact_decisions += in_doubt || looked_at_again > 0 ? 1 : 0;
  if (!in_doubt) return true;
  return within_reach_exactly(a, b, steps, margin);
}

/// The largest separation over the axes of a and the image of b that `shift` names, rounded once,
/// and so of the right sign: <= 0 exactly if they touch. What exceeds the largest double is that.
template <int Dim>
[[nodiscard]] ABUT_HD double gap(const Box<Dim>& a, const Box<Dim>& b, const ImageShift& shift,
                                 const Lattice& lattice) noexcept;

}  // namespace abut::exact
