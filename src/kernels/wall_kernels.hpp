#pragma once

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Centers of spheres, and the cells of a wall that they are looked for in.
struct WallJob {
  const double* spheres;          ///< records of center and radius
  std::size_t count;              ///< of spheres
  bool is_moved;                  ///< whether centers are brought back at all
  double inverse[3][3];           ///< rows that center - translation is multiplied by
  double translation[3];          ///< of a motion
  double origin[3];               ///< of the cells
  double cells_per_length[3];     ///< along each axis
  std::int32_t size[3];           ///< cells along each axis; less than 2^31 in all
  const std::uint32_t* occupied;  ///< a bit for each cell, x fastest
};

struct WallKernels {
  /// Writes the numbers of the spheres whose cell is occupied, ascending, to `near`, which has room
  /// for all. Treats whole vectors of spheres from the front, and
  /// returns how many spheres; the rest is the caller's. Products and sums are rounded one by one.
  std::size_t (*find_near)(const WallJob& job, std::uint32_t* near, std::size_t& found);
};

/// `level` must be available.
[[nodiscard]] WallKernels wall_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] WallKernels simd_wall_kernels(std::int64_t target);

}  // namespace abut::kernels
