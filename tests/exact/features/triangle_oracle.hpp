#pragma once

#include "exact/features/triangle_predicate.hpp"

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>

/// The point of a triangle nearest to a center, in rational numbers, by another way than the
/// library's: of all points that may be it (the corners, the feet of perpendiculars within sides
/// and face) the one at the smallest distance.
namespace abut::testing {

using RationalPoint = std::array<mpq_class, 3>;

[[nodiscard]] inline mpq_class dot(const RationalPoint& a, const RationalPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// a + t * b
[[nodiscard]] inline RationalPoint moved(const RationalPoint& a, const mpq_class& t,
                                         const RationalPoint& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

[[nodiscard]] inline RationalPoint rational(const double (&point)[3]) {
  return {mpq_class(point[0]), mpq_class(point[1]), mpq_class(point[2])};
}

struct NearestPart {
  exact::TrianglePart part = exact::TrianglePart::corner_0;
  mpq_class distance_squared;
  RationalPoint vector;  ///< from the center to the nearest point
};

class NearestPartFinder {
 public:
  /// Corners are seen from the center.
  NearestPartFinder(const RationalPoint& center, const exact::Triangle& triangle)
      : corner_{moved(rational(triangle.corner[0]), -1, center),
                moved(rational(triangle.corner[1]), -1, center),
                moved(rational(triangle.corner[2]), -1, center)} {}

  [[nodiscard]] NearestPart find() {
    using exact::TrianglePart;
    nearest_ = {TrianglePart::corner_0, dot(corner_[0], corner_[0]), corner_[0]};
    consider(TrianglePart::corner_1, corner_[1]);
    consider(TrianglePart::corner_2, corner_[2]);
    consider_side(TrianglePart::side_01, corner_[0], corner_[1]);
    consider_side(TrianglePart::side_02, corner_[0], corner_[2]);
    consider_side(TrianglePart::side_12, corner_[1], corner_[2]);
    consider_face();
    return nearest_;
  }

 private:
  /// Of points at the same distance the first stays.
  void consider(exact::TrianglePart part, const RationalPoint& point) {
    const mpq_class squared = dot(point, point);
    if (squared < nearest_.distance_squared) nearest_ = {part, squared, point};
  }

  void consider_side(exact::TrianglePart part, const RationalPoint& from, const RationalPoint& to) {
    const RationalPoint edge = moved(to, -1, from);
    const mpq_class squared = dot(edge, edge);
    if (squared == 0) return;
    const mpq_class t = -dot(from, edge) / squared;
    if (t > 0 && t < 1) consider(part, moved(from, t, edge));
  }

  /// Weights of the corners from the normal equations.
  void consider_face() {
    const RationalPoint e = moved(corner_[1], -1, corner_[0]);
    const RationalPoint f = moved(corner_[2], -1, corner_[0]);
    const mpq_class ee = dot(e, e), ef = dot(e, f), ff = dot(f, f);
    const mpq_class determinant = ee * ff - ef * ef;
    if (determinant == 0) return;
    const mpq_class ae = -dot(corner_[0], e), af = -dot(corner_[0], f);
    const mpq_class s = (ae * ff - af * ef) / determinant;
    const mpq_class t = (af * ee - ae * ef) / determinant;
    if (s <= 0 || t <= 0 || s + t >= 1) return;
    consider(exact::TrianglePart::face, moved(moved(corner_[0], s, e), t, f));
  }

  RationalPoint corner_[3];
  NearestPart nearest_;
};

[[nodiscard]] inline NearestPart nearest_part_by_rationals(const RationalPoint& center,
                                                           const exact::Triangle& triangle) {
  return NearestPartFinder(center, triangle).find();
}

[[nodiscard]] inline std::optional<exact::TrianglePart> part_within_reach_by_rationals(
    const RationalPoint& center, double radius, const exact::Triangle& triangle, double margin) {
  const NearestPart nearest = nearest_part_by_rationals(center, triangle);
  const mpq_class reach = mpq_class(radius) + mpq_class(margin);
  if (nearest.distance_squared > reach * reach) return std::nullopt;
  return nearest.part;
}

[[nodiscard]] inline NearestPart nearest_part_by_rationals(const double (&center)[3],
                                                           const exact::Triangle& triangle) {
  return nearest_part_by_rationals(rational(center), triangle);
}

[[nodiscard]] inline std::optional<exact::TrianglePart> part_within_reach_by_rationals(
    const exact::Sphere<3>& sphere, const exact::Triangle& triangle, double margin) {
  return part_within_reach_by_rationals(rational(sphere.center), sphere.radius, triangle, margin);
}

/// Where a triangle moved by n A is seen from: x - n A.
[[nodiscard]] inline RationalPoint moved_back(const double (&center)[3], const ImageShift& shift,
                                              const exact::Lattice& lattice) {
  RationalPoint result = rational(center);
  for (std::size_t k = 0; k < 3; ++k) {
    if (!lattice.periodic[k]) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result[axis] -= exact::numbers(shift)[k] * mpq_class(lattice.vectors[k][axis]);
    }
  }
  return result;
}

}  // namespace abut::testing
