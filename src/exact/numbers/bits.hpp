#pragma once

#include "base/host_device.hpp"

#include <bit>
#include <cstdint>

namespace abut::exact {

__extension__ using Uint128 = unsigned __int128;
__extension__ using Int128 = __int128;

/// A finite double as sign * significand * 2^exponent, exactly.
struct Decomposed {
  bool negative;
  std::uint64_t significand;  ///< < 2^53; 0 for both zeros
  int exponent;               ///< >= -1074
};

ABUT_HD inline Decomposed decompose(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto biased = static_cast<int>((bits >> 52) & 0x7FF);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const bool negative = (bits >> 63) != 0;
  if (biased == 0) return {negative, fraction, -1074};
  return {negative, fraction | (std::uint64_t{1} << 52), biased - 1075};
}

}  // namespace abut::exact
