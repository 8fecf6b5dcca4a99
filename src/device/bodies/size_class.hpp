#pragma once

#include "base/host_device.hpp"
#include "device/bodies/sphere_columns.hpp"

#include <bit>
#include <cstdint>

namespace abut::device {

/// Sizes are told apart in half octaves, counted from the largest radius downwards; the last class
/// holds all that are smaller. A half octave is the exponent of a double and the first bit behind.
inline constexpr std::uint32_t size_classes = 64;

/// The half octave of a radius; -0.0 + 0.0 has no sign bit.
[[nodiscard]] ABUT_HD inline std::uint32_t half_octave_of(double radius) noexcept {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(radius + 0.0) >> 51);
}

/// Radii of this half octave are below the end.
[[nodiscard]] ABUT_HD inline double end_of_half_octave(std::uint32_t half_octave) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(half_octave + 1) << 51);
}

/// The class of a radius that is at most the largest.
[[nodiscard]] ABUT_HD inline std::uint32_t size_class_of(
    double radius, std::uint32_t largest_half_octave) noexcept {
  const std::uint32_t below = largest_half_octave - half_octave_of(radius);
  return below < size_classes ? below : size_classes - 1;
}

/// Body of the histogram: the class of element k.
template <class Spheres>
struct SizeClassOf {
  Spheres elements;
  std::uint32_t largest_half_octave;

  [[nodiscard]] ABUT_HD std::uint32_t operator()(std::uint64_t k) const noexcept {
    return size_class_of(elements.radius(static_cast<std::uint32_t>(k)), largest_half_octave);
  }
};

}  // namespace abut::device
