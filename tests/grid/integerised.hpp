#pragma once

#include "grid/integerise.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::testing {

/// Discs of one radius on given places of the x axis, and their cells.
struct Line {
  std::vector<double> x;
  double radius = 0.5;
  double margin = 0.0;
};

template <int Dim>
[[nodiscard]] grid::Bounds<Dim> bounds_of(const std::vector<exact::Sphere<Dim>>& spheres) {
  grid::Bounds<Dim> bounds;
  if (spheres.empty()) return bounds;
  std::vector<double> radii;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    bounds.lower[axis] = bounds.upper[axis] = spheres.front().center[axis];
    for (const auto& sphere : spheres) {
      bounds.lower[axis] = std::min(bounds.lower[axis], sphere.center[axis]);
      bounds.upper[axis] = std::max(bounds.upper[axis], sphere.center[axis]);
    }
  }
  for (const auto& sphere : spheres) radii.push_back(sphere.radius);
  std::sort(radii.rbegin(), radii.rend());
  bounds.largest_radius = radii[0];
  if (radii.size() > 1) bounds.second_largest_radius = radii[1];
  return bounds;
}

template <int Dim>
[[nodiscard]] grid::CellCoordinates<Dim> integerise(const std::vector<exact::Sphere<Dim>>& spheres,
                                                    double margin,
                                                    base::DetectionContext& context) {
  return grid::integerise<Dim>(spheres, bounds_of(spheres), margin, context);
}

/// x cells of the line and their number, which comes last.
[[nodiscard]] inline std::vector<std::int32_t> cells_of(const Line& line) {
  std::vector<exact::Sphere<2>> discs;
  for (const double x : line.x) discs.push_back({{x, 0.0}, line.radius});
  base::DetectionContext context;
  const auto cells = integerise(discs, line.margin, context);
  std::vector<std::int32_t> result(cells.axis(0).begin(), cells.axis(0).end());
  result.push_back(cells.cell_count[0]);
  return result;
}

[[nodiscard]] inline mpq_class reach_of(const Line& line) {
  return 2 * mpq_class(line.radius) + mpq_class(line.margin);
}

/// The largest x whose distance from `from` is within the reach in real numbers.
[[nodiscard]] inline double farthest_within_reach(double from, const Line& line) {
  const mpq_class limit = mpq_class(from) + reach_of(line);
  double x = limit.get_d();
  while (mpq_class(x) > limit) x = std::nextafter(x, -HUGE_VAL);
  while (mpq_class(std::nextafter(x, HUGE_VAL)) <= limit) x = std::nextafter(x, HUGE_VAL);
  return x;
}

}  // namespace abut::testing
