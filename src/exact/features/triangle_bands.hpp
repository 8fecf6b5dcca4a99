#pragma once

namespace abut::exact {

// Bounds of the errors of the filter of triangle_predicate.cpp, relative to what is multiplied: 16,
// 256, 32 and 64 units of u = 2^-53 (docs/derivations/triangle_predicate.md).
inline constexpr double band_along = 0x1p-49;
inline constexpr double band_of_turn = 0x1p-45;
inline constexpr double band_to_side = 0x1p-48;
inline constexpr double band_to_face = 0x1p-47;

// Lengths whose products of four neither over- nor underflow, as far as the bands can see.
inline constexpr double smallest_safe_length = 0x1p-200;
inline constexpr double largest_safe_length = 0x1p200;

}  // namespace abut::exact
