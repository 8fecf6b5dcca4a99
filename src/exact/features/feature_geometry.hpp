#pragma once

#include "exact/features/triangle_predicate.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <abut/quantity.hpp>

#include <array>

namespace abut::exact {

/// The position of a sphere beside the point of a wall that is nearest to its center. Each number
/// is off by at most one unit in the last place, of vectors and points in that of the largest
/// component.
struct FeatureGeometry {
  double gap = 0.0;                ///< distance - radius; <= 0 exactly if they touch
  double distance = 0.0;           ///< from the center to the point
  std::array<double, 3> normal{};  ///< unit vector from the center to the point; 0 if they are one
  std::array<double, 3> point{};   ///< on the wall where its shift moves it
  std::array<double, 3> vector{};  ///< from the center to the point
};

/// A point, a segment or a triangle, which may be degenerate: the convex hull of its corners.
struct Feature {
  double corner[3][3];
  int corners;  ///< 1, 2 or 3
};

/// Measures the `wanted` quantities of a sphere and the point nearest to its center of a feature
/// moved by the shift n of a lattice A. For all finite numbers; what exceeds the largest double is
/// that. docs/derivations/contact_geometry.md proves the bounds.
[[nodiscard]] FeatureGeometry geometry_of(const Sphere<3>& sphere, const Feature& feature,
                                          const ImageShift& shift, const Lattice& lattice,
                                          Quantities wanted) noexcept;

}  // namespace abut::exact
