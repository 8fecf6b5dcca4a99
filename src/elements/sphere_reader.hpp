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

  /// `spheres` must outlive it and be spheres in 3D.
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
[[nodiscard]] inline exact::Sphere<3> sphere_at(const kernels::ElementColumns& columns,
                                                std::size_t k) noexcept {
  return {{columns.center[0][k], columns.center[1][k], columns.center[2][k]}, columns.radius[k]};
}

}  // namespace abut::elements
