#pragma once

#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "lattice/cell_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace abut::lattice {

/// The coordinates along the sides of a cell that occur among some elements, and how far these lie
/// from the origin.
template <int Dim>
struct CellExtent {
  using Vector = std::array<double, Dim>;

  Vector lower = filled(std::numeric_limits<double>::infinity());
  Vector upper = filled(-std::numeric_limits<double>::infinity());
  Vector farthest{};  ///< on each axis of space, of either sign

  void include(const CellExtent& others) noexcept {
    for (std::size_t k = 0; k < Dim; ++k) {
      lower[k] = std::min(lower[k], others.lower[k]);
      upper[k] = std::max(upper[k], others.upper[k]);
      farthest[k] = std::max(farthest[k], others.farthest[k]);
    }
  }

 private:
  static constexpr Vector filled(double value) noexcept {
    Vector result{};
    result.fill(value);
    return result;
  }
};

/// Returns the extent of the spheres sphere_at(0), sphere_at(1), ...
template <int Dim, class SphereAt>
[[nodiscard]] CellExtent<Dim> extent_of(std::size_t count_of_spheres, const SphereAt& sphere_at,
                                        const CellSides<Dim>& cell) noexcept {
  return with_count<Dim>(cell.count, [&](auto count) {
    const CellSides<Dim> map = cell;  // a copy that nothing can change
    CellExtent<Dim> extent;
    for (std::size_t number = 0; number < count_of_spheres; ++number) {
      const exact::Sphere<Dim> sphere = sphere_at(number);
      for (std::size_t k = 0; k < count(); ++k) {
        const double place = map.coordinate(k, sphere.center);
        extent.lower[k] = std::min(extent.lower[k], place);
        extent.upper[k] = std::max(extent.upper[k], place);
      }
      for (std::size_t axis = 0; axis < Dim; ++axis) {
        extent.farthest[axis] = std::max(extent.farthest[axis], std::fabs(sphere.center[axis]));
      }
    }
    return extent;
  });
}

template <int Dim>
[[nodiscard]] CellExtent<Dim> extent_of(std::span<const exact::Sphere<Dim>> spheres,
                                        const CellSides<Dim>& cell) noexcept {
  return extent_of<Dim>(
      spheres.size(), [&](std::size_t k) { return spheres[k]; }, cell);
}

/// Returns the extent of a box. If sides are aligned, it is that of its elements, in rounded
/// numbers too.
template <int Dim>
[[nodiscard]] CellExtent<Dim> extent_of(const grid::Bounds<Dim>& bounds,
                                        const CellSides<Dim>& cell) noexcept {
  std::array<exact::Sphere<Dim>, 2> corners{};
  std::copy(bounds.lower.begin(), bounds.lower.end(), corners[0].center);
  std::copy(bounds.upper.begin(), bounds.upper.end(), corners[1].center);
  return extent_of<Dim>(std::span<const exact::Sphere<Dim>>(corners), cell);
}

}  // namespace abut::lattice
