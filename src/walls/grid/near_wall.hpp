#pragma once

#include "kernels/element_kernels.hpp"
#include "kernels/walls/wall_kernels.hpp"
#include "walls/grid/rest_frame.hpp"
#include "walls/grid/wall_grid.hpp"
#include "walls/grid/wall_planes.hpp"

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

/// What tells how far a wall reaches: the planes of its cells, and the margin of the spheres.
struct ReachOfWall {
  const WallPlanes& planes;
  double margin;
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

  /// Fills the columns for the first `count` of `near`, which `find` has found in `spheres`, and
  /// lists which of them, counted in `near`, are not out of reach by the planes of their cell.
  /// `near` and `kept` have room for most_spheres.
  [[nodiscard]] std::span<const std::uint32_t> sift(const kernels::ElementColumns& spheres,
                                                    std::span<std::uint32_t> near,
                                                    std::size_t count, const ReachOfWall& reach,
                                                    kernels::NearColumns& columns,
                                                    std::span<std::uint32_t> kept) const noexcept;

 private:
  void look_up(const kernels::ElementColumns& spheres, std::uint32_t number, std::size_t k,
               const ReachOfWall& reach, kernels::NearColumns& columns) const noexcept;

  const WallGrid& grid_;
  const RestFrame& frame_;
  kernels::WallKernels kernels_;
  kernels::WallJob job_{};
};

}  // namespace abut::walls
