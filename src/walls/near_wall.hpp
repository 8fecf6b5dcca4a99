#pragma once

#include "exact/sphere.hpp"
#include "kernels/wall_kernels.hpp"
#include "walls/rest_frame.hpp"
#include "walls/wall_grid.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::walls {

/// Finds the spheres whose cell in a grid names some part of the wall: few of many, so that this is
/// what most spheres cost.
class NearWall {
 public:
  /// `grid` and `frame` must outlive it; `simd` must be available.
  NearWall(const WallGrid& grid, const RestFrame& frame, Simd simd) noexcept;

  /// Returns the places in `spheres` of those, ascending, in `near`, which has room for all.
  [[nodiscard]] std::span<const std::uint32_t> find(std::span<const exact::Sphere<3>> spheres,
                                                    std::span<std::uint32_t> near) const noexcept;

 private:
  const WallGrid& grid_;
  const RestFrame& frame_;
  kernels::WallKernels kernels_;
  kernels::WallJob job_{};
};

}  // namespace abut::walls
