#pragma once

#include "exact/features/feature_geometry.hpp"
#include "exact/features/triangle_oracle.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

/// The geometry of a contact with a wall in rational numbers, roots with thousands of bits; and
/// whether what was measured differs from it by one unit in the last place at most.
namespace abut::testing {

inline constexpr Quantities all_quantities =
    Quantity::gap | Quantity::normal | Quantity::point | Quantity::distance | Quantity::vector;

/// What the geometry follows from.
struct WallGeometry {
  RationalPoint center;
  RationalPoint vector;       ///< from the center to the point of the wall
  RationalPoint normal_side;  ///< along the normal, of any length
  mpq_class distance_squared;
  int sign = 1;  ///< -1 where the distance counts as negative
};

[[nodiscard]] inline mpf_class wide(const mpq_class& number) {
  return mpf_class(number, 6000);
}

/// A unit in the last place.
[[nodiscard]] inline double last_place_of(double size) {
  constexpr double largest = std::numeric_limits<double>::max();
  if (std::fabs(size) == largest) return 0x1p971;
  return std::nextafter(std::fabs(size), largest) - std::fabs(size);
}

[[nodiscard]] inline double largest_component(const std::array<double, 3>& vector) {
  return std::max({std::fabs(vector[0]), std::fabs(vector[1]), std::fabs(vector[2])});
}

[[nodiscard]] inline bool is_within_doubles(const mpf_class& number) {
  return abs(number) <= std::numeric_limits<double>::max();
}

/// What is wrong with a number, or nothing.
[[nodiscard]] inline std::string fault_of(const char* what, double found, const mpf_class& expected,
                                          double last_place) {
  const std::string where = std::string(what) + " is " + std::to_string(found) + ", not " +
                            std::to_string(expected.get_d()) + "; ";
  if (found == 0.0 && std::signbit(found)) return where;
  if (!is_within_doubles(expected)) {
    const bool is_largest = std::fabs(found) == std::numeric_limits<double>::max();
    return is_largest ? "" : where;
  }
  return abs(mpf_class(found, 6000) - expected) <= mpf_class(last_place) ? "" : where;
}

/// The same of vectors: within a unit in the last place of the largest component.
[[nodiscard]] inline std::string fault_of(const char* what, const std::array<double, 3>& found,
                                          const std::array<mpf_class, 3>& expected) {
  const double last_place = last_place_of(largest_component(found));
  std::string faults;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    faults += fault_of(what, found[axis], expected[axis], last_place);
  }
  return faults;
}

/// What differs by more than the contract allows, or nothing.
[[nodiscard]] inline std::string fault_of(const exact::FeatureGeometry& found,
                                          const WallGeometry& expected, double radius) {
  const mpf_class distance = sqrt(wide(expected.distance_squared));
  const mpq_class r(radius);
  const mpf_class both = distance + wide(r);
  mpf_class gap = expected.sign < 0 ? mpf_class(-both) : wide(0);
  if (expected.sign > 0 && both != 0) gap = wide(expected.distance_squared - r * r) / both;
  const mpf_class length = sqrt(wide(dot(expected.normal_side, expected.normal_side)));
  std::array<mpf_class, 3> normal{wide(0), wide(0), wide(0)};
  std::array<mpf_class, 3> vector = normal, point = normal;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (length != 0) normal[axis] = wide(expected.normal_side[axis]) / length;
    vector[axis] = wide(expected.vector[axis]);
    point[axis] = wide(expected.center[axis] + expected.vector[axis]);
  }
  return fault_of("distance", found.distance, expected.sign * distance,
                  last_place_of(found.distance)) +
         fault_of("gap", found.gap, gap, last_place_of(found.gap)) +
         ((found.gap <= 0.0) == (gap <= 0) ? "" : "the gap has the wrong sign; ") +
         fault_of("normal", found.normal, normal) + fault_of("vector", found.vector, vector) +
         fault_of("point", found.point, point);
}

/// The contract of boxes, whose bounds are moved already, as it is told: the nearest point outside,
/// the nearest face inside.
[[nodiscard]] inline WallGeometry geometry_of_box(const RationalPoint& center,
                                                  const RationalPoint& lower,
                                                  const RationalPoint& upper,
                                                  std::size_t dimensions) {
  WallGeometry expected;
  mpq_class smallest = -1;
  std::size_t nearest_axis = 0;
  bool is_upper = false;
  expected.center = center;
  for (std::size_t axis = 0; axis < dimensions; ++axis) {
    const mpq_class& x = center[axis];
    expected.vector[axis] = (x < lower[axis] ? lower[axis] : x > upper[axis] ? upper[axis] : x) - x;
    expected.distance_squared += expected.vector[axis] * expected.vector[axis];
    for (const bool upper_face : {false, true}) {
      const mpq_class depth = upper_face ? mpq_class(upper[axis] - x) : mpq_class(x - lower[axis]);
      if (smallest >= 0 && depth >= smallest) continue;
      smallest = depth;
      nearest_axis = axis;
      is_upper = upper_face;
    }
  }
  expected.normal_side = expected.vector;
  if (expected.distance_squared > 0) return expected;
  expected.sign = -1;
  expected.distance_squared = smallest * smallest;
  expected.vector[nearest_axis] = is_upper ? smallest : mpq_class(-smallest);
  expected.normal_side[nearest_axis] = is_upper ? -1 : 1;
  return expected;
}

}  // namespace abut::testing
