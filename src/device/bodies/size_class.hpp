#pragma once

#include "base/host_device.hpp"
#include "device/bodies/check.hpp"
#include "device/bodies/ordered_double.hpp"
#include "exact/sphere.hpp"

#include <bit>
#include <cstdint>
#include <limits>

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

/// What some elements of one class come to: how many they are, and ordered_bits, of which the
/// smallest count. So they may be joined in any order, also by several threads at once.
///
///   least    lower corner of the box of their centers | upper corner, negative | largest radius,
///            negative
template <int Dim>
struct SizeClassNumbers {
  static constexpr int width = 2 * Dim + 1;

  std::uint64_t elements;
  std::uint64_t least[width];

  [[nodiscard]] ABUT_HD static SizeClassNumbers of_none() noexcept {
    SizeClassNumbers numbers{};
    for (std::uint64_t& number : numbers.least) number = std::numeric_limits<std::uint64_t>::max();
    return numbers;
  }

  ABUT_HD void include_center(const double (&center)[Dim]) noexcept {
    for (int axis = 0; axis < Dim; ++axis) {
      include(axis, center[axis]);
      include(Dim + axis, -center[axis]);
    }
  }
  ABUT_HD void include_radius(double radius) noexcept { include(2 * Dim, -radius); }

  ABUT_HD void add(const SizeClassNumbers& more) noexcept {
    elements += more.elements;
    for (int k = 0; k < width; ++k) {
      if (more.least[k] < least[k]) least[k] = more.least[k];
    }
  }

 private:
  ABUT_HD void include(int k, double value) noexcept {
    const std::uint64_t ordered = ordered_bits(value);
    if (ordered < least[k]) least[k] = ordered;
  }
};

/// What an item adds to the class of that number.
template <int Dim>
struct OfSizeClass {
  static constexpr std::uint32_t no_class = size_classes;

  std::uint32_t number = no_class;
  SizeClassNumbers<Dim> numbers = SizeClassNumbers<Dim>::of_none();
};

/// Body of join_by_class: element k alone. Where all are of one size there are no classes.
template <class Spheres>
struct SizeClassOf {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  const Extent<Dim>* all;  ///< of the elements

  [[nodiscard]] ABUT_HD OfSizeClass<Dim> operator()(std::uint64_t k) const noexcept {
    OfSizeClass<Dim> item;
    if (!(all->smallest_radius < all->largest_radius)) return item;
    const exact::Sphere<Dim> sphere = elements[static_cast<std::uint32_t>(k)];
    item.number = size_class_of(sphere.radius, half_octave_of(all->largest_radius));
    item.numbers.elements = 1;
    item.numbers.include_center(sphere.center);
    item.numbers.include_radius(sphere.radius);
    return item;
  }
};

}  // namespace abut::device
