#pragma once

#include "base/sphere_predicate.hpp"

#include <optional>

/// The stages of within_reach_exactly, cheapest first, each with a name of its own so that tests
/// can enter it. A stage that cannot tell returns nothing; the last always decides.
namespace abut::base {

/// The filter's own operations, if none of them rounds.
template <int Dim>
[[nodiscard]] std::optional<bool> decide_if_nothing_rounded(const Sphere<Dim>& a,
                                                            const Sphere<Dim>& b,
                                                            double margin) noexcept;

/// Pairs of doubles, unless distance and reach are equal to some 28 digits.
template <int Dim>
[[nodiscard]] std::optional<bool> decide_doubled(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                 double margin) noexcept;

/// 128-bit integers, if all numbers fit into 61 bits over a common power of two.
template <int Dim>
[[nodiscard]] std::optional<bool> decide_scaled(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                double margin) noexcept;

/// The long accumulator.
template <int Dim>
[[nodiscard]] bool decide_accumulated(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                      double margin) noexcept;

}  // namespace abut::base
