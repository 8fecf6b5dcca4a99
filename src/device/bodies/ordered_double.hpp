#pragma once

#include "base/host_device.hpp"

#include <bit>
#include <cstdint>

namespace abut::device {

/// Whole numbers in the order of the doubles that they stand for.
[[nodiscard]] ABUT_HD inline std::uint64_t ordered_bits(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

[[nodiscard]] ABUT_HD inline double double_of(std::uint64_t ordered) noexcept {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return std::bit_cast<double>((ordered & sign) != 0 ? ordered ^ sign : ~ordered);
}

}  // namespace abut::device
