#pragma once

#include "kernels/element_kernels.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Most spheres that are looked at together; whole vectors of any length.
inline constexpr std::size_t most_spheres = 512;

/// The plane in the middle of two parallel ones with all parts near a cell between them, and half
/// of their distance. Few bytes, so that those of many cells stay in the caches.
struct alignas(32) CellPlanes {
  float normal[3];   ///< no longer than one
  float half_width;  ///< rounded up
  double offset;
};

/// Spheres, and the cells of a wall that they are looked for in.
struct WallJob {
  ElementColumns spheres;              ///< as the caller gives them, to be checked
  std::size_t count;                   ///< of spheres
  bool is_moved;                       ///< whether centers are brought back at all
  double inverse[3][3];                ///< rows that center - translation is multiplied by
  double translation[3];               ///< of a motion
  double factor_of_reach;              ///< of that motion, as `offset_of_reach`
  double offset_of_reach;              ///< what distances grow by when centers are brought back
  double origin[3];                    ///< of the cells
  double cells_per_length[3];          ///< along each axis
  std::int32_t size[3];                ///< cells along each axis; less than 2^28 in all
  const std::uint32_t* occupied;       ///< a bit for each cell, x fastest
  const std::uint64_t* places_before;  ///< the bits that are set in the words before each
  const CellPlanes* planes;            ///< one for each bit that is set
  double error_of_planes;              ///< of heights over them
  double margin;                       ///< of the reach
};

/// Spheres near a wall, as they are looked for at rest.
struct NearColumns {
  double center[3][most_spheres];     ///< brought back
  double reach[most_spheres];         ///< errors of planes included
  std::uint64_t place[most_spheres];  ///< of the cell among those that are occupied
};

/// What was found beside the spheres near a wall.
struct WallFinds {
  std::size_t near;       ///< spheres whose cell is occupied
  double largest_radius;  ///< of all that were treated
  std::size_t kept;       ///< of those near the wall, by the planes of their cells
};

struct WallKernels {
  /// Writes the numbers of the spheres whose cell is occupied, ascending, to `near`, which has room
  /// for all. Treats whole vectors of spheres from the front, and returns how many spheres; the
  /// rest is the caller's. Stops before a vector that holds a number that is not finite, or a
  /// negative radius. Products and sums are rounded one by one.
  std::size_t (*find_near)(const WallJob& job, std::uint32_t* near, WallFinds& finds);

  /// Fills the columns for the `finds.near` spheres that find_near wrote, and lists in `kept` which
  /// of them, counted in `near`, are not out of reach by the planes of their cell. `near` and
  /// `kept` have room for most_spheres, and `near` may be written to behind its spheres. Returns
  /// false where it does nothing, and the caller does it.
  bool (*sift)(const WallJob& job, std::uint32_t* near, NearColumns& columns, std::uint32_t* kept,
               WallFinds& finds);
};

/// `level` must be available.
[[nodiscard]] WallKernels wall_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] WallKernels simd_wall_kernels(std::int64_t target);

}  // namespace abut::kernels
