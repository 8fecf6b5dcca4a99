#pragma once

#include "base/host_device.hpp"
#include "exact/sphere_predicate.hpp"

#include <cstdint>
#include <optional>

/// The stages of within_reach_exactly, cheapest first, each with a name of its own so that tests
/// can enter it. A stage that cannot tell returns nothing; the last always decides.
namespace abut::exact {

/// A number with none of these bits has at most 26 significant ones, and its square at most 52.
inline constexpr std::uint64_t bits_that_squares_lose = (std::uint64_t{1} << 27) - 1;
/// The smallest number whose square stays in the normal range.
inline constexpr double smallest_exact_root = 0x1p-480;

/// Reaches whose squares doubled precision knows, and differences by which it decides, in units of
/// the squared reach: see THE ERROR in sphere_predicate-inl.hpp.
inline constexpr double smallest_double_double_reach = 0x1p-400;
inline constexpr double largest_double_double_reach = 0x1p400;
inline constexpr double double_double_band = 0x1p-95;

/// Stage 1: the filter's own operations, if none of them rounds.
template <int Dim>
[[nodiscard]] ABUT_HD std::optional<bool> decide_if_nothing_rounded(const Sphere<Dim>& a,
                                                                    const Sphere<Dim>& b,
                                                                    double margin) noexcept;

/// Stage 2: pairs of doubles, unless distance and reach are equal to some 28 digits.
template <int Dim>
[[nodiscard]] ABUT_HD std::optional<bool> decide_in_double_double(const Sphere<Dim>& a,
                                                                  const Sphere<Dim>& b,
                                                                  double margin) noexcept;

/// Stage 3: 128-bit integers, if all numbers fit into 61 bits over a common power of two.
template <int Dim>
[[nodiscard]] ABUT_HD std::optional<bool> decide_scaled(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                        double margin) noexcept;

/// Stage 4: the long accumulator.
template <int Dim>
[[nodiscard]] ABUT_HD bool decide_accumulated(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                              double margin) noexcept;

}  // namespace abut::exact
