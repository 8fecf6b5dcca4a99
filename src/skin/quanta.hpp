#pragma once

#include "exact/sphere.hpp"
#include "kernels/candidate_kernels.hpp"

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::skin {

/// Lengths in whole quanta, so small that all that is compared fits into 32 bits
/// (docs/derivations/skin.md).
template <int Dim>
class Quanta {
 public:
  /// None that fit.
  Quanta() = default;

  /// Quanta of lengths that are at most `largest` in sum, and of coordinates as far as they are
  /// from `middle`.
  Quanta(double largest, const std::array<double, Dim>& middle) noexcept;

  /// True if there are such quanta; there are none if numbers are extreme.
  [[nodiscard]] bool fit() const noexcept { return scale_.per_length > 0.0; }

  [[nodiscard]] const kernels::QuantumScale& scale() const noexcept { return scale_; }

  /// slots[k] = the sphere of number numbers[k], or sphere k where `numbers` is null.
  void fill(const exact::Sphere<Dim>* spheres, const ElementIndex* numbers,
            std::span<kernels::QuantumSphere> slots, Simd level) const;

  [[nodiscard]] kernels::QuantumSphere of(const exact::Sphere<Dim>& sphere) const noexcept {
    kernels::QuantumSphere result{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result.center[axis] = whole(sphere.center[axis] - scale_.middle[axis]);
    }
    result.radius = whole(sphere.radius);
    return result;
  }

  /// Rounded towards zero. What is too large is so by a rounding, or is of no account.
  [[nodiscard]] std::int32_t whole(double length) const noexcept {
    const double quanta = length * scale_.per_length;
    return static_cast<std::int32_t>(std::min(most, std::max(-most, quanta)));
  }

 private:
  static constexpr double most = 0x1p29;

  kernels::QuantumScale scale_{{}, 0.0, most};
};

}  // namespace abut::skin
