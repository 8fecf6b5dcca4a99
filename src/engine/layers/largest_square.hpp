#pragma once

#include <cstdint>

namespace abut::engine {

/// Returns the square of the longest distance within reach where distances are roots of whole
/// numbers, in units of which `step` has so many: the largest whole n with
///
///   n step^2 <= (units (diameter + margin))^2
///
/// for the very numbers. The step is a power of two, `units` a whole number, and the reach shorter
/// than 2^15 units.
[[nodiscard]] std::int32_t largest_square_within(double diameter, double margin, double step,
                                                 double units) noexcept;

}  // namespace abut::engine
