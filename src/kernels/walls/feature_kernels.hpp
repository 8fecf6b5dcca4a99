#pragma once

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Most contacts of one job: what workers with a small stack have room for.
inline constexpr std::size_t most_features = 64;

/// Spheres and features of a wall, in columns.
struct FeatureColumns {
  double center[3][most_features];
  double radius[most_features];
  double corner[3][3][most_features];  ///< of each corner its coordinates
};

/// Components of what is given are 0 or at least so large: then no error of a product underflows,
/// so that splitting and fusing give the same one.
inline constexpr double smallest_given = 0x1p-200;

/// What moves the features: n A.
struct FeatureMoves {
  double lattice[3][3];  ///< rows; 0, or from smallest_given to exact::largest_input
  std::int32_t number[3][3][most_features];  ///< along each axis, how often each row is added
};

/// Contacts with features of one kind to measure, and where the results go; nullptr: not wanted.
struct FeatureJob {
  const FeatureColumns* columns;
  const FeatureMoves* moves;  ///< nullptr: no feature is moved
  std::size_t count;
  double* gaps;
  double* distances;
  double (*normals)[3];
  double (*points)[3];
  double (*vectors)[3];
};

/// Geometry of contacts with walls in vectors of contacts.
struct FeatureKernels {
  /// Measures whole vectors of contacts with points, segments or triangles (1, 2 or 3 `corners`)
  /// from the front, and returns how many contacts; the rest is the caller's. Of those that it
  /// treated it lists the ones whose bits may not be those of exact::geometry_of, which the caller
  /// measures again. `open` has room for most_features.
  std::size_t (*measure)(const FeatureJob& job, int corners, std::uint32_t* open,
                         std::size_t& open_count);
};

/// `level` must be available.
[[nodiscard]] FeatureKernels feature_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] FeatureKernels simd_feature_kernels(std::int64_t target);

}  // namespace abut::kernels
