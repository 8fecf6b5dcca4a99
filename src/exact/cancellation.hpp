#pragma once

#include "base/host_device.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <algorithm>
#include <cmath>

namespace abut::exact {

/// Cancellation of coordinates by lattice vectors beyond which a compensated sum is not enough: a
/// difference that is smaller than this, relative to its largest term, is summed exactly.
inline constexpr double most_cancellation = 0x1p-40;

/// The largest coordinate, and the largest component of a vector that moves b.
template <int Dim>
[[nodiscard]] ABUT_HD double largest_term(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                          const LatticeSteps<Dim>& steps) noexcept {
  double largest = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    largest = std::max(std::max(largest, std::fabs(a.center[axis])), std::fabs(b.center[axis]));
    for (const auto& step : steps) {
      largest = std::max(largest, std::fabs(step.number * step.vector[axis]));
    }
  }
  return largest;
}

// What doubled precision bears where contacts with walls are measured, in scalar code and in
// vectors. docs/derivations/contact_geometry.md, section 6, proves what the constants say.

/// The largest input and the shortest vector that is multiplied for which no product or quotient in
/// doubled precision leaves the range.
inline constexpr double largest_input = 0x1p64;
inline constexpr double smallest_length = 0x1p-100;

/// The cancellation of a length that doubled precision still bears.
inline constexpr double most_cancellation_of_line = 0x1p-40;
inline constexpr double most_cancellation_of_plane = 0x1p-38;

/// Bounds of the errors of vectors, relative to their length.
inline constexpr double error_of_corner = 0x1p-95;
inline constexpr double error_of_line = 0x1p-94;
inline constexpr double error_of_plane = 0x1p-92;

/// The bound of the error of a sum in doubled precision, relative to what is added.
inline constexpr double error_of_pair_sum = 0x1p-100;

/// Errors that, beside rounding once, stay below one unit in the last place: of a direction, and of
/// a number relative to itself.
inline constexpr double largest_error_of_direction = 0x1p-57;
inline constexpr double largest_error_of_number = 0x1p-55;

}  // namespace abut::exact
