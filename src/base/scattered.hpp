#pragma once

#include <cstddef>
#include <cstdint>

namespace abut::base {

/// A bijection of 64 bits that scatters neighbours (the finalizer of MurmurHash3, A. Appleby).
[[nodiscard]] constexpr std::uint64_t scattered(std::uint64_t k) noexcept {
  k = (k ^ (k >> 33)) * 0xff51afd7ed558ccdU;
  k = (k ^ (k >> 33)) * 0xc4ceb9fe1a85ec53U;
  return k ^ (k >> 33);
}

/// Returns one of so many numbers, fewer than 2^32, by the upper bits of a scattered number: a
/// remainder would take longer.
[[nodiscard]] constexpr std::size_t one_of(std::size_t count, std::uint64_t draw) noexcept {
  return (scattered(draw) >> 32) * count >> 32;
}

}  // namespace abut::base
