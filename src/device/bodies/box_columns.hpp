#pragma once

#include "base/host_device.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "exact/box.hpp"
#include "exact/sphere.hpp"

#include <abut/element_view.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::device {

/// The sphere that stands for a box wherever elements are mapped to cells (exact::Elements): its
/// center is the lower corner, its radius half of the widest side, rounded; upwards
/// where the smallest numbers have no half. Halves are subtracted, since a width may exceed the
/// largest double.
template <int Dim>
[[nodiscard]] ABUT_HD inline exact::Sphere<Dim> stand_in(const exact::Box<Dim>& box) noexcept {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) {
    sphere.center[axis] = box.lower[axis];
    double half = 0.5 * box.upper[axis] - 0.5 * box.lower[axis];
    // Only of the smallest numbers there is no half.
    if (2.0 * half < box.upper[axis] - box.lower[axis]) {
      half += std::numeric_limits<double>::denorm_min();
    }
    sphere.radius = std::max(sphere.radius, half);
  }
  return sphere;
}

template <int Dim>
[[nodiscard]] ABUT_HD inline exact::Sphere<Dim> stand_in(
    const exact::Sphere<Dim>& sphere) noexcept {
  return sphere;
}

/// The caller's boxes where they lie, of `float` or `double`. A search sees their stand-ins.
template <int Dim>
struct BoxColumns {
  using Column = NumberColumn<EitherNumber>;
  static constexpr int dimensions = Dim;
  static constexpr Shape shape = Shape::box;

  Column lower[Dim];
  Column upper[Dim];
  std::uint32_t count;

  [[nodiscard]] ABUT_HD exact::Box<Dim> whole(std::uint32_t k) const noexcept {
    exact::Box<Dim> box{};
    for (int axis = 0; axis < Dim; ++axis) {
      box.lower[axis] = lower[axis][k];
      box.upper[axis] = upper[axis][k];
    }
    return box;
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> operator[](std::uint32_t k) const noexcept {
    return stand_in(whole(k));
  }

  [[nodiscard]] ABUT_HD double radius(std::uint32_t k) const noexcept { return (*this)[k].radius; }

  [[nodiscard]] ABUT_HD double coordinate(std::uint32_t k, int axis) const noexcept {
    return lower[axis][k];
  }
};

}  // namespace abut::device
