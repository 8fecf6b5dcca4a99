#pragma once

#include "kernels/plane/plane_view.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// engine::PlaneGrid: the map from centers to positions and columns. Axes are those of the
/// elements, but for `per_unit` and `last`, which are those of the plane.
struct PlaneMap {
  double lower[3];
  double unit;
  float per_unit[2];
  float last[2];  ///< column and row
  std::uint32_t first_column;
  std::uint32_t row_length;
};

/// The kernels of one instruction set for elements in a plane. All give the same numbers, and the
/// same pairs in the same order.
struct PlaneKernels {
  /// Writes the positions of the first elements of some packed ones, axis by axis. Returns how many
  /// it wrote: any number, the caller writes the others.
  std::size_t (*locate)(const double* records, std::size_t count, int dimensions,
                        const PlaneMap& map, float* const* positions);

  /// The same of the columns that belong to positions on the two axes of the plane.
  std::size_t (*find_columns)(const float* along, const float* across, std::size_t count,
                              const PlaneMap& map, std::uint32_t* columns);

  /// Tests each element against those ahead of it in its row, and against those of the next row.
  void (*search)(const PlaneView& plane, SearchJob& job, int dimensions);
};

/// `level` must be available.
[[nodiscard]] PlaneKernels plane_kernels(Simd level);

[[nodiscard]] PlaneKernels scalar_plane_kernels();

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] PlaneKernels simd_plane_kernels(std::int64_t target);

}  // namespace abut::kernels
