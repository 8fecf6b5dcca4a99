#pragma once

#include "exact/sphere.hpp"

#include <cstddef>
#include <span>

namespace abut::kernels {

/// Spheres or discs whose numbers lie in columns of doubles: centers by axis, then radii.
///
///   column   0 .. Dim - 1   Dim .. 2   3
///   holds    centers        nothing    radii
///
/// Number k of a column lies k strides behind its begin. A column whose stride is 0 is one number
/// that all spheres share. Columns may lie in each other, as those of packed records do.
struct StridedSpheres {
  static constexpr int radii = 3;

  const double* begin[4];
  std::ptrdiff_t stride[4];  ///< in doubles
  std::size_t size;          ///< number of spheres

  /// The first spheres.
  [[nodiscard]] StridedSpheres first(std::size_t count) const noexcept {
    StridedSpheres columns = *this;
    columns.size = count;
    return columns;
  }

  /// Every so manyth sphere, from the first on.
  [[nodiscard]] StridedSpheres every(std::size_t step) const noexcept {
    StridedSpheres columns = *this;
    for (std::ptrdiff_t& along : columns.stride) along *= static_cast<std::ptrdiff_t>(step);
    columns.size = (size + step - 1) / step;
    return columns;
  }

  /// The same spheres, all of one radius: an array of radii is read at its first place only.
  [[nodiscard]] StridedSpheres with_one_radius() const noexcept {
    StridedSpheres columns = *this;
    if (columns.stride[radii] == 1) columns.stride[radii] = 0;
    return columns;
  }

  [[nodiscard]] const double* place(int column, std::size_t k) const noexcept {
    return begin[column] + static_cast<std::ptrdiff_t>(k) * stride[column];
  }
  [[nodiscard]] double radius(std::size_t k) const noexcept { return *place(radii, k); }
};

/// Sphere k of some columns.
template <int Dim>
[[nodiscard]] exact::Sphere<Dim> sphere_at(const StridedSpheres& columns, std::size_t k) noexcept {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = *columns.place(axis, k);
  sphere.radius = columns.radius(k);
  return sphere;
}

/// The columns of spheres that are packed, one record each.
template <int Dim>
[[nodiscard]] StridedSpheres strided_spheres(std::span<const exact::Sphere<Dim>> spheres) noexcept {
  StridedSpheres columns{};
  columns.size = spheres.size();
  if (spheres.empty()) return columns;
  for (int axis = 0; axis < Dim; ++axis) {
    columns.begin[axis] = &spheres.front().center[axis];
    columns.stride[axis] = Dim + 1;
  }
  columns.begin[StridedSpheres::radii] = &spheres.front().radius;
  columns.stride[StridedSpheres::radii] = Dim + 1;
  return columns;
}

/// The first record of spheres that are packed, number by number; null where they are not.
template <int Dim>
[[nodiscard]] const double* packed_records(const StridedSpheres& columns) noexcept {
  constexpr int radii = StridedSpheres::radii;
  for (int axis = 0; axis < Dim; ++axis) {
    if (columns.stride[axis] != Dim + 1) return nullptr;
    if (columns.begin[axis] != columns.begin[0] + axis) return nullptr;
  }
  if (columns.stride[radii] != Dim + 1) return nullptr;
  return columns.begin[radii] == columns.begin[0] + Dim ? columns.begin[0] : nullptr;
}

/// Brings sphere k, which will be read soon, into the nearest cache.
template <int Dim>
void fetch(const StridedSpheres& columns, std::size_t k) noexcept {
  for (int axis = 0; axis < Dim; ++axis) __builtin_prefetch(columns.place(axis, k));
  __builtin_prefetch(columns.place(StridedSpheres::radii, k));
}

}  // namespace abut::kernels
