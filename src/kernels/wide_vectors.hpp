#pragma once

#include <cstdint>

namespace abut::kernels {

/// How a processor that has vectors of 512 bits computes them.
enum class WideVectors : std::uint8_t {
  whole,     ///< at once
  in_halves  ///< one half after the other, so that two vectors of 256 bits take no longer
};

/// The same of this processor. Zen 4 computes halves (AMD, Software Optimization Guide for the AMD
/// Zen4 Microarchitecture, publication 57647).
[[nodiscard]] WideVectors wide_vectors_here() noexcept;

}  // namespace abut::kernels
