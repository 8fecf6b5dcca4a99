#pragma once

#include "exact/sphere.hpp"
#include "kernels/element_kernels.hpp"

#include <abut/element_view.hpp>

#include <cstddef>
#include <span>

namespace abut::elements {

/// Reads the caller's spheres, a block at a time, as columns of contiguous doubles: where they are
/// if they lie so, and as copies if not. So what looks at each sphere only once need not write it.
class SphereReader {
 public:
  /// Numbers of a sphere, for each of which a block needs room.
  static constexpr std::size_t numbers = 4;

  /// `spheres` must outlive it and be spheres or discs.
  explicit SphereReader(const ElementView& spheres);

  /// Returns the columns of `count` spheres from number `first` on, unchecked. What is copied goes
  /// to `room`.
  [[nodiscard]] kernels::ElementColumns read(std::size_t first, std::size_t count,
                                             std::span<double> room) const;

 private:
  [[nodiscard]] const double* column(int number, std::size_t first, std::span<double> room) const;

  const ElementView& spheres_;
  const double* in_place_[numbers];  ///< null where numbers are copied
};

/// Sphere k of some columns.
template <int Dim>
[[nodiscard]] exact::Sphere<Dim> sphere_at(const kernels::ElementColumns& columns,
                                           std::size_t k) noexcept {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = columns.center[axis][k];
  sphere.radius = columns.radius[k];
  return sphere;
}

}  // namespace abut::elements
