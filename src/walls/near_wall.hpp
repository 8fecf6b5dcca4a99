#pragma once

#include "kernels/element_kernels.hpp"
#include "kernels/walls/wall_kernels.hpp"
#include "walls/rest_frame.hpp"
#include "walls/wall_grid.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::walls {

/// Spheres near a wall among those of a block.
struct NearSpheres {
  std::span<const std::uint32_t> numbers;  ///< in the block, ascending
  std::size_t valid;                       ///< spheres before the first one that is not valid
  double largest_radius;                   ///< of those
};

/// Finds the spheres whose cell in a grid names some part of the wall: few of many, so that this is
/// what most spheres cost.
class NearWall {
 public:
  /// `grid` and `frame` must outlive it; `simd` must be available.
  NearWall(const WallGrid& grid, const RestFrame& frame, Simd simd) noexcept;

  /// Looks at `count` spheres, up to the first one that is not valid. `near` has room for all.
  [[nodiscard]] NearSpheres find(const kernels::ElementColumns& spheres, std::size_t count,
                                 std::span<std::uint32_t> near) const noexcept;

 private:
  const WallGrid& grid_;
  const RestFrame& frame_;
  kernels::WallKernels kernels_;
  kernels::WallJob job_{};
};

}  // namespace abut::walls
