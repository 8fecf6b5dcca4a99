#pragma once

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Positions now and then. Those of now are columns, or records of the coordinates, which one more
/// number may follow.
struct DisplacementJob {
  const double* now[3];    ///< columns; of records the first alone
  std::size_t numbers;     ///< of a record; 1 for columns
  const double* then[3];   ///< columns; one for each dimension
  std::size_t count;       ///< elements
  double scale;            ///< power of two that all lengths are multiplied by
  double largest_squared;  ///< displacements beyond are not told apart
};

/// The squares of the two largest displacements, and whether some exceeds the largest that is told
/// apart or is no number: then the two mean nothing.
struct DisplacementBounds {
  double first = 0.0;
  double second = 0.0;
  bool exceeded = false;
};

struct DisplacementKernels {
  /// Treats whole vectors of elements from the front, and returns how many elements; the rest is
  /// the caller's. Products and sums are rounded one by one, so that all levels have the same bits.
  std::size_t (*compare)(const DisplacementJob& job, int dimensions, DisplacementBounds& largest);
};

/// `level` must be available.
[[nodiscard]] DisplacementKernels displacement_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] DisplacementKernels simd_displacement_kernels(std::int64_t target);

}  // namespace abut::kernels
