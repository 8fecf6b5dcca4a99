#pragma once

#include "exact/box.hpp"
#include "kernels/strided_spheres.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace abut::kernels {

/// Boxes or rectangles whose numbers lie in columns of doubles: lower corners by axis, then upper
/// ones.
///
///   column   0 .. Dim - 1    Dim .. 2   3 .. 2 + Dim
///   holds    lower corners   nothing    upper corners
///
/// Number k of a column lies k strides behind its begin. Columns may lie in each other, as those of
/// packed records do.
struct StridedBoxes {
  static constexpr int upper_corners = 3;

  const double* begin[6];
  std::ptrdiff_t stride[6];  ///< in doubles
  std::size_t size;          ///< number of boxes

  [[nodiscard]] const double* place(int column, std::size_t k) const noexcept {
    return begin[column] + static_cast<std::ptrdiff_t>(k) * stride[column];
  }
  [[nodiscard]] double lower(int axis, std::size_t k) const noexcept { return *place(axis, k); }
  [[nodiscard]] double upper(int axis, std::size_t k) const noexcept {
    return *place(upper_corners + axis, k);
  }
};

/// Box k of some columns.
template <int Dim>
[[nodiscard]] exact::Box<Dim> box_at(const StridedBoxes& columns, std::size_t k) noexcept {
  exact::Box<Dim> box{};
  for (int axis = 0; axis < Dim; ++axis) {
    box.lower[axis] = columns.lower(axis, k);
    box.upper[axis] = columns.upper(axis, k);
  }
  return box;
}

/// The columns of boxes that are packed, one record each.
template <int Dim>
[[nodiscard]] StridedBoxes strided_boxes(std::span<const exact::Box<Dim>> boxes) noexcept {
  StridedBoxes columns{};
  columns.size = boxes.size();
  if (boxes.empty()) return columns;
  for (int axis = 0; axis < Dim; ++axis) {
    const int upper = StridedBoxes::upper_corners + axis;
    columns.begin[axis] = &boxes.front().lower[axis];
    columns.begin[upper] = &boxes.front().upper[axis];
    columns.stride[axis] = columns.stride[upper] = 2 * Dim;
  }
  return columns;
}

/// The sphere that stands for a box (exact::Elements). Halves are subtracted, since a width may
/// exceed the largest double.
template <int Dim>
[[nodiscard]] exact::Sphere<Dim> stand_in(const exact::Box<Dim>& box) noexcept {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) {
    sphere.center[axis] = box.lower[axis];
    sphere.radius = std::max(sphere.radius, 0.5 * box.upper[axis] - 0.5 * box.lower[axis]);
  }
  return sphere;
}

/// The centers of the spheres that stand for boxes, where they lie, all with the same radius.
[[nodiscard]] inline StridedSpheres lower_corners(const StridedBoxes& boxes,
                                                  const double* radius) noexcept {
  StridedSpheres spheres{};
  spheres.size = boxes.size;
  for (int axis = 0; axis < 3; ++axis) {
    spheres.begin[axis] = boxes.begin[axis];
    spheres.stride[axis] = boxes.stride[axis];
  }
  spheres.begin[StridedSpheres::radii] = radius;
  return spheres;
}

/// Brings box k, which will be read soon, into the nearest cache.
template <int Dim>
void fetch(const StridedBoxes& columns, std::size_t k) noexcept {
  for (int axis = 0; axis < Dim; ++axis) {
    __builtin_prefetch(columns.place(axis, k));
    __builtin_prefetch(columns.place(StridedBoxes::upper_corners + axis, k));
  }
}

}  // namespace abut::kernels
