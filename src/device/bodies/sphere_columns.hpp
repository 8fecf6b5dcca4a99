#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::device {

/// The caller's spheres where they lie: numbers of type T, aligned for it, any distance apart.
template <int Dim, class T>
struct SphereColumns {
  struct Column {
    const std::byte* first;
    std::ptrdiff_t stride_bytes;

    [[nodiscard]] ABUT_HD double operator[](std::uint32_t k) const noexcept {
      return static_cast<double>(
          *reinterpret_cast<const T*>(first + static_cast<std::ptrdiff_t>(k) * stride_bytes));
    }
  };

  Column center[Dim];
  Column radii;          ///< its `first` is null where all have the common radius
  double common_radius;  ///< of all, if there are no radii
  std::uint32_t count;

  [[nodiscard]] ABUT_HD double radius(std::uint32_t k) const noexcept {
    return radii.first == nullptr ? common_radius : radii[k];
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> operator[](std::uint32_t k) const noexcept {
    exact::Sphere<Dim> sphere{};
    for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = center[axis][k];
    sphere.radius = radius(k);
    return sphere;
  }
};

}  // namespace abut::device
