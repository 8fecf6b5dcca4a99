#pragma once

#include "base/host_device.hpp"
#include "exact/periodic_predicate.hpp"

#include <optional>

/// The stages of within_reach_exactly with a lattice, cheapest first, each with a name of its own
/// so that tests can enter it. A stage that cannot tell returns nothing; the last always decides.
namespace abut::exact {

/// Stage 1 decides, if x_a - x_b - n A is a double on every axis and no step towards it rounds, the
/// question of open space, with a at this difference and b at the origin.
template <int Dim>
[[nodiscard]] ABUT_HD std::optional<bool> decide_if_difference_is_exact(
    const Sphere<Dim>& a, const Sphere<Dim>& b, const LatticeSteps<Dim>& steps,
    double margin) noexcept;

/// Stage 2: pairs of doubles, unless distance and reach are equal to some 28 digits of the largest
/// number.
template <int Dim>
[[nodiscard]] ABUT_HD std::optional<bool> decide_in_double_double(const Sphere<Dim>& a,
                                                                  const Sphere<Dim>& b,
                                                                  const LatticeSteps<Dim>& steps,
                                                                  double margin) noexcept;

/// Stage 3: the long accumulator.
template <int Dim>
[[nodiscard]] ABUT_HD bool decide_accumulated(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                              const LatticeSteps<Dim>& steps,
                                              double margin) noexcept;

}  // namespace abut::exact
