#pragma once

#include "kernels/walls/feature_kernels.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Beside the numbers of exact::TrianglePart: no part is within reach; the vectors do not know.
inline constexpr std::uint8_t no_part = 7;
inline constexpr std::uint8_t open_part = 8;

/// The parts of triangles within reach, in vectors of triangles.
struct TriangleKernels {
  /// parts[k] = what exact::part_within_reach returns for sphere k and triangle k in open space,
  /// with the reach in place of the radius, or open_part. It does so for whole vectors from the
  /// front, and returns how many; the rest is the caller's.
  std::size_t (*decide)(const FeatureColumns& columns, std::size_t count, std::uint8_t* parts);
};

/// `level` must be available.
[[nodiscard]] TriangleKernels triangle_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] TriangleKernels simd_triangle_kernels(std::int64_t target);

}  // namespace abut::kernels
