// The slow path of the triangles: all numbers of one decision become whole numbers over a common
// power of two, and the signs of the polynomials are those of whole numbers. Nothing is divided:
// comparisons are multiplied by the squared length of a side or of the normal. A triangle that is
// moved by n A is seen from x - n A instead of x.
//
// Short numbers, such as those of a grid, fit into 128 bits with all that is made of them, and are
// decided several times as fast as others.

#include "exact/features/nearest_part.hpp"
#include "exact/features/triangle_predicate.hpp"
#include "exact/image_difference.hpp"
#include "exact/integer_vector.hpp"
#include "exact/numbers/big_integer.hpp"
#include "exact/numbers/bit_range.hpp"
#include "exact/numbers/small_integer.hpp"

#include <cstddef>
#include <optional>

namespace abut::exact {
namespace {

/// Bits of short numbers. Differences are below 2^20, components of vector products below 2^41, the
/// product of three below 2^63, its square below 2^126.
constexpr int most_short_bits = 19;

/// The corners of a triangle as seen from the center of a sphere.
template <class Integer>
class ExactSigns {
 public:
  ExactSigns(const IntegerVector<Integer>& center, const Triangle& triangle, int exponent) noexcept
      : corners_{IntegerVector<Integer>(triangle.corner[0], exponent) - center,
                 IntegerVector<Integer>(triangle.corner[1], exponent) - center,
                 IntegerVector<Integer>(triangle.corner[2], exponent) - center},
        normal_(cross(corners_[1] - corners_[0], corners_[2] - corners_[0])) {}

  [[nodiscard]] int along(std::size_t from, std::size_t to) const noexcept {
    return dot(corners_[to] - corners_[from], corners_[from]).sign();
  }

  [[nodiscard]] int turn(std::size_t from, std::size_t to) const noexcept {
    return dot(normal_, cross(corners_[from], corners_[to])).sign();
  }

  [[nodiscard]] bool is_within(const Integer& reach, TrianglePart nearest) const noexcept {
    const Integer reach_squared = reach * reach;
    if (nearest == TrianglePart::face) {
      const Integer height = dot(corners_[0], normal_);
      return height * height <= reach_squared * dot(normal_, normal_);
    }
    if (nearest <= TrianglePart::corner_2) {
      const IntegerVector<Integer>& corner = corners_[static_cast<std::size_t>(nearest)];
      return dot(corner, corner) <= reach_squared;
    }
    const auto [from, to] = ends_of(nearest);
    const IntegerVector<Integer> edge = corners_[to] - corners_[from];
    const IntegerVector<Integer> moment = cross(corners_[from], edge);
    return dot(moment, moment) <= reach_squared * dot(edge, edge);
  }

 private:
  IntegerVector<Integer> corners_[3];
  IntegerVector<Integer> normal_;
};

/// The radius and the margin are those of the sphere; where it is, `center` says.
template <class Integer>
std::optional<TrianglePart> decide(const IntegerVector<Integer>& center, const Sphere<3>& sphere,
                                   const Triangle& triangle, double margin, int exponent) noexcept {
  const ExactSigns<Integer> signs(center, triangle, exponent);
  const auto nearest = nearest_part(signs);
  const Integer reach = Integer(sphere.radius, exponent) + Integer(margin, exponent);
  return nearest && signs.is_within(reach, *nearest) ? nearest : std::nullopt;
}

/// Returns the part within reach, from signs that are all known.
template <class Integer>
TrianglePart nearest(const IntegerVector<Integer>& center, const Triangle& triangle,
                     int exponent) noexcept {
  return *nearest_part(ExactSigns<Integer>(center, triangle, exponent));
}

BitRange range_of(const Sphere<3>& sphere, const Triangle& triangle, double margin) noexcept {
  BitRange range;
  for (const auto& corner : triangle.corner) include(range, corner);
  include(range, sphere.center);
  range.include(sphere.radius);
  range.include(margin);
  return range;
}

/// Returns the sphere at x - n A, if that is three doubles and no step towards them rounds.
std::optional<Sphere<3>> moved_back(const Sphere<3>& sphere,
                                    const LatticeSteps<3>& steps) noexcept {
  const Sphere<3> origin{};
  Sphere<3> moved{{}, sphere.radius};
  for (int axis = 0; axis < 3; ++axis) {
    const CompensatedSum sum = image_difference(sphere, origin, steps, axis);
    if (sum.rounded()) return std::nullopt;
    moved.center[axis] = sum.value().high;
  }
  return moved;
}

}  // namespace

/// Asks, if the center moved back by the shift is exactly three doubles, the question without a
/// lattice.
TrianglePart nearest_part_exactly(const Sphere<3>& sphere, const Triangle& triangle,
                                  const LatticeSteps<3>& steps) noexcept {
  const auto moved = moved_back(sphere, steps);
  BitRange range = range_of(Sphere<3>{}, triangle, 0.0);
  include(range, moved ? moved->center : sphere.center);
  if (!moved) include(range, steps);
  const int exponent = range.lowest();
  if (moved && range.bits() <= most_short_bits) {
    return nearest(IntegerVector<SmallInteger>(moved->center, exponent), triangle, exponent);
  }
  return moved ? nearest(IntegerVector<BigInteger>(moved->center, exponent), triangle, exponent)
               : nearest(moved_back(sphere.center, steps, exponent), triangle, exponent);
}

std::optional<TrianglePart> part_within_reach_exactly(const Sphere<3>& sphere,
                                                      const Triangle& triangle,
                                                      double margin) noexcept {
  const BitRange range = range_of(sphere, triangle, margin);
  const int exponent = range.lowest();
  if (range.bits() <= most_short_bits) {
    return decide(IntegerVector<SmallInteger>(sphere.center, exponent), sphere, triangle, margin,
                  exponent);
  }
  return decide(IntegerVector<BigInteger>(sphere.center, exponent), sphere, triangle, margin,
                exponent);
}

/// Asks, if the center moved back by the shift is exactly three doubles, the question without a
/// lattice.
std::optional<TrianglePart> part_within_reach_exactly(const Sphere<3>& sphere,
                                                      const Triangle& triangle,
                                                      const LatticeSteps<3>& steps,
                                                      double margin) noexcept {
  if (const auto moved = moved_back(sphere, steps)) {
    return part_within_reach_exactly(*moved, triangle, margin);
  }
  BitRange range = range_of(sphere, triangle, margin);
  include(range, steps);
  const int exponent = range.lowest();
  return decide(moved_back(sphere.center, steps, exponent), sphere, triangle, margin, exponent);
}

}  // namespace abut::exact
