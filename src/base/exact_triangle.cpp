// The slow path of the triangles: all numbers of one decision become whole numbers over a common
// power of two, and the signs of the polynomials are those of whole numbers. Nothing is divided:
// comparisons are multiplied by the squared length of a side or of the normal.

#include "base/big_integer.hpp"
#include "base/bits.hpp"
#include "base/nearest_part.hpp"
#include "base/triangle_predicate.hpp"

#include <algorithm>
#include <bit>

namespace abut::base {
namespace {

struct Vector {
  BigInteger x, y, z;
};

Vector operator-(const Vector& a, const Vector& b) noexcept {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

BigInteger dot(const Vector& a, const Vector& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector cross(const Vector& a, const Vector& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The exponent of the lowest bit that is set in any of the numbers.
class LowestBit {
 public:
  void include(double value) noexcept {
    const Decomposed d = decompose(value);
    if (d.significand == 0) return;
    exponent_ = std::min(exponent_, d.exponent + std::countr_zero(d.significand));
  }
  void include(const double (&point)[3]) noexcept {
    for (const double x : point) include(x);
  }

  [[nodiscard]] int exponent() const noexcept { return exponent_; }

 private:
  int exponent_ = 1024;
};

Vector whole(const double (&point)[3], int exponent) noexcept {
  return {{point[0], exponent}, {point[1], exponent}, {point[2], exponent}};
}

/// Corners seen from the center.
class ExactSigns {
 public:
  ExactSigns(const Sphere<3>& sphere, const Triangle& triangle, int exponent) noexcept {
    const Vector center = whole(sphere.center, exponent);
    for (std::size_t k = 0; k < 3; ++k) corners_[k] = whole(triangle.corner[k], exponent) - center;
    normal_ = cross(corners_[1] - corners_[0], corners_[2] - corners_[0]);
  }

  [[nodiscard]] int along(std::size_t from, std::size_t to) const noexcept {
    return dot(corners_[to] - corners_[from], corners_[from]).sign();
  }

  [[nodiscard]] int turn(std::size_t from, std::size_t to) const noexcept {
    return dot(normal_, cross(corners_[from], corners_[to])).sign();
  }

  [[nodiscard]] bool is_within(const BigInteger& reach_squared,
                               TrianglePart nearest) const noexcept {
    if (nearest == TrianglePart::face) {
      const BigInteger height = dot(corners_[0], normal_);
      return height * height <= reach_squared * dot(normal_, normal_);
    }
    if (nearest <= TrianglePart::corner_2) {
      const Vector& corner = corners_[static_cast<std::size_t>(nearest)];
      return dot(corner, corner) <= reach_squared;
    }
    const auto [from, to] = ends_of(nearest);
    const Vector edge = corners_[to] - corners_[from];
    const Vector moment = cross(corners_[from], edge);
    return dot(moment, moment) <= reach_squared * dot(edge, edge);
  }

 private:
  Vector corners_[3];
  Vector normal_;
};

}  // namespace

std::optional<TrianglePart> part_within_reach_exactly(const Sphere<3>& sphere,
                                                      const Triangle& triangle,
                                                      double margin) noexcept {
  LowestBit lowest;
  for (const auto& corner : triangle.corner) lowest.include(corner);
  lowest.include(sphere.center);
  lowest.include(sphere.radius);
  lowest.include(margin);
  const ExactSigns signs(sphere, triangle, lowest.exponent());
  const auto nearest = nearest_part(signs);
  const BigInteger reach =
      BigInteger(sphere.radius, lowest.exponent()) + BigInteger(margin, lowest.exponent());
  return nearest && signs.is_within(reach * reach, *nearest) ? nearest : std::nullopt;
}

}  // namespace abut::base
