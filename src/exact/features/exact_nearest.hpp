#pragma once

#include "exact/features/triangle_predicate.hpp"
#include "exact/integer_vector.hpp"
#include "exact/lattice.hpp"
#include "exact/numbers/big_integer.hpp"
#include "exact/sphere.hpp"

#include <array>

namespace abut::exact {

/// The vector from the center of a sphere to the nearest point of a vertex, a line or a plane that
/// a shift moves, as a quotient of whole numbers, for all finite numbers. What it returns is the
/// real result rounded, off by at most 2^-90 of itself besides; see FeatureGeometry.
class ExactNearest {
 public:
  /// Finds the vector to a part of the triangle: to a corner, to the line through a side that has a
  /// length, or to the plane of a triangle that has an area.
  ExactNearest(const Sphere<3>& sphere, const Triangle& triangle, TrianglePart part,
               const LatticeSteps<3>& steps) noexcept;

  [[nodiscard]] double gap() const noexcept;
  [[nodiscard]] double distance() const noexcept;
  [[nodiscard]] std::array<double, 3> vector() const noexcept;
  [[nodiscard]] std::array<double, 3> normal() const noexcept;
  [[nodiscard]] std::array<double, 3> point() const noexcept;

 private:
  /// Set vector and squared distance, each for one kind of part.
  void take_corner(const IntegerVector<BigInteger>& corner) noexcept;
  void take_line(const IntegerVector<BigInteger>& from,
                 const IntegerVector<BigInteger>& edge) noexcept;
  void take_plane(const IntegerVector<BigInteger>& corner,
                  const IntegerVector<BigInteger>& normal) noexcept;

  int exponent_;  ///< all numbers are whole multiples of two to this power
  BigInteger radius_;
  BigInteger center_[3];
  BigInteger vector_[3];         ///< times divisor_
  BigInteger divisor_;           ///< > 0
  BigInteger distance_squared_;  ///< times of_square_
  BigInteger of_square_;         ///< > 0
};

}  // namespace abut::exact
