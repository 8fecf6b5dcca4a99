#pragma once

#include "exact/lattice.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/sphere.hpp"

#include <array>

namespace abut::exact {

/// The line from the center of a to that of the image of b that a shift names: v = x_b + n A - x_a.
///
/// Where numbers are ordinary (`is_ordinary`), what it gives is one fixed sequence of operations,
/// which kernels/measure_kernels repeats in vectors; elsewhere numbers are scaled by powers of two
/// first. docs/derivations/contact_geometry.md proves the bounds.
template <int Dim>
class CenterLine {
 public:
  CenterLine(const Sphere<Dim>& a, const Sphere<Dim>& b, const ImageShift& shift,
             const Lattice& lattice) noexcept;

  /// The unit vector along v, 0 where the centers are one point. Each component errs by at most one
  /// unit in the last place of the largest. Exchanging a and b and negating n negates it.
  [[nodiscard]] std::array<double, 3> normal() const noexcept;

  /// The point on the line in the middle between the surfaces, hence of the overlap:
  /// x_a + v / 2 + normal (r_a - r_b) / 2. It errs by at most one unit in the last place of its
  /// largest component, or by 2^-94 of the largest number of a and b where that is more.
  [[nodiscard]] std::array<double, 3> point() const noexcept;

 private:
  void subtract_large(const Sphere<Dim>& b, const LatticeSteps<Dim>& steps) noexcept;

  Sphere<Dim> a_;
  DoubleDouble difference_of_radii_;
  DoubleDouble vector_[Dim];  ///< v times 2^exponent_
  int exponent_ = 0;          ///< not 0 only where a component exceeds the largest double
  bool is_ordinary_ = false;
};

/// Numbers beyond these leave the range in which nothing of the sequence over- or underflows.
inline constexpr double largest_ordinary = 0x1p480;
inline constexpr double smallest_ordinary = 0x1p-400;

}  // namespace abut::exact
