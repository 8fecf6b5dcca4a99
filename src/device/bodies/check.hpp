#pragma once

#include "base/host_device.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/box.hpp"

#include <abut/element_view.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::device {

inline constexpr std::uint32_t no_element = std::numeric_limits<std::uint32_t>::max();

/// Returns whether the contract takes a sphere: finite numbers, no negative radius.
template <int Dim>
[[nodiscard]] ABUT_HD inline bool is_valid(const exact::Sphere<Dim>& sphere) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  bool valid = sphere.radius >= 0.0 && sphere.radius <= largest;
  for (const double x : sphere.center) valid = valid && std::fabs(x) <= largest;
  return valid;
}

/// Returns whether the contract takes a box: finite corners, none below the other.
template <int Dim>
[[nodiscard]] ABUT_HD inline bool is_valid(const exact::Box<Dim>& box) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  bool valid = true;
  for (int axis = 0; axis < Dim; ++axis) {
    valid = valid && std::fabs(box.lower[axis]) <= largest &&
            std::fabs(box.upper[axis]) <= largest && box.lower[axis] <= box.upper[axis];
  }
  return valid;
}

/// The box of some centers, the smallest and the two largest radii, and the first element that is
/// no valid one; of no element, an inverted box. Numbers of an invalid element are not in it.
template <int Dim>
struct Extent {
  double lower[Dim];
  double upper[Dim];
  double smallest_radius;
  double largest_radius;
  double second_largest_radius;
  std::uint64_t first_bad;  ///< as wide as the others: no byte is copied that nobody wrote

  [[nodiscard]] ABUT_HD static Extent of_none() noexcept {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Extent extent{};
    for (int axis = 0; axis < Dim; ++axis) {
      extent.lower[axis] = infinite;
      extent.upper[axis] = -infinite;
    }
    extent.smallest_radius = infinite;
    extent.first_bad = no_element;
    return extent;
  }
};

/// Joins two extents. Minima and maxima do not depend on the order in which many are joined.
struct JoinExtents {
  template <int Dim>
  [[nodiscard]] ABUT_HD Extent<Dim> operator()(const Extent<Dim>& a,
                                               const Extent<Dim>& b) const noexcept {
    Extent<Dim> joined{};
    for (int axis = 0; axis < Dim; ++axis) {
      joined.lower[axis] = std::min(a.lower[axis], b.lower[axis]);
      joined.upper[axis] = std::max(a.upper[axis], b.upper[axis]);
    }
    joined.smallest_radius = std::min(a.smallest_radius, b.smallest_radius);
    joined.largest_radius = std::max(a.largest_radius, b.largest_radius);
    joined.second_largest_radius =
        std::max(std::max(a.second_largest_radius, b.second_largest_radius),
                 std::min(a.largest_radius, b.largest_radius));
    joined.first_bad = std::min(a.first_bad, b.first_bad);
    return joined;
  }
};

/// The extent of one sphere.
template <int Dim>
[[nodiscard]] ABUT_HD inline Extent<Dim> extent_of(const exact::Sphere<Dim>& sphere) noexcept {
  Extent<Dim> extent = Extent<Dim>::of_none();
  for (int axis = 0; axis < Dim; ++axis) {
    extent.lower[axis] = sphere.center[axis];
    extent.upper[axis] = sphere.center[axis];
  }
  extent.smallest_radius = sphere.radius;
  extent.largest_radius = sphere.radius;
  return extent;
}

/// The extent of an element by its sphere. Lower corners of boxes within reach are as far apart as
/// the wider one is wide, however narrow the other: the largest radius counts twice.
template <class Spheres>
[[nodiscard]] ABUT_HD inline Extent<Spheres::dimensions> extent_of_element(
    const exact::Sphere<Spheres::dimensions>& sphere) noexcept {
  Extent<Spheres::dimensions> extent = extent_of(sphere);
  if constexpr (Spheres::shape == Shape::box) extent.second_largest_radius = sphere.radius;
  return extent;
}

/// Body of the first stage: the extent of element k alone, or that it is a bad one.
template <class Spheres>
struct ElementExtent {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;

  [[nodiscard]] ABUT_HD Extent<Dim> operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    if (is_valid(elements.whole(number))) return extent_of_element<Spheres>(elements[number]);
    Extent<Dim> extent = Extent<Dim>::of_none();
    extent.first_bad = number;
    return extent;
  }
};

}  // namespace abut::device
