#pragma once

namespace abut::lattice {

/// Factors above and below which no sum or length of a few doubles is off: their errors are some
/// units in the last place.
inline constexpr double up = 1.0 + 0x1p-40;
inline constexpr double down = 1.0 - 0x1p-40;

}  // namespace abut::lattice
