#pragma once

#include "kernels/element_kernels.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Spheres, and the cells of a wall that they are looked for in.
struct WallJob {
  ElementColumns spheres;         ///< as the caller gives them, to be checked
  std::size_t count;              ///< of spheres
  bool is_moved;                  ///< whether centers are brought back at all
  double inverse[3][3];           ///< rows that center - translation is multiplied by
  double translation[3];          ///< of a motion
  double origin[3];               ///< of the cells
  double cells_per_length[3];     ///< along each axis
  std::int32_t size[3];           ///< cells along each axis; less than 2^31 in all
  const std::uint32_t* occupied;  ///< a bit for each cell, x fastest
};

/// What was found beside the spheres near a wall.
struct WallFinds {
  std::size_t near;       ///< spheres whose cell is occupied
  double largest_radius;  ///< of all that were treated
};

struct WallKernels {
  /// Writes the numbers of the spheres whose cell is occupied, ascending, to `near`, which has room
  /// for all. Treats whole vectors of spheres from the front, and returns how many spheres; the
  /// rest is the caller's. Stops before a vector that holds a number that is not finite, or a
  /// negative radius. Products and sums are rounded one by one.
  std::size_t (*find_near)(const WallJob& job, std::uint32_t* near, WallFinds& finds);
};

/// `level` must be available.
[[nodiscard]] WallKernels wall_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] WallKernels simd_wall_kernels(std::int64_t target);

}  // namespace abut::kernels
