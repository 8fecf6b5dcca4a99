#pragma once

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Pairs of spheres to measure, and where the results go; nullptr: not wanted.
struct MeasureJob {
  const ContactPair* pairs;
  const ImageShift* shifts;  ///< nullptr: all zero
  std::size_t count;
  const double* first;         ///< exact::Sphere of the pairs' first numbers
  const double* second;        ///< of their second ones
  const double (*lattice)[3];  ///< rows; zeros on axes that are not periodic
  double* gaps;
  double* distances;
  double (*normals)[3];
  double (*points)[3];
  double (*vectors)[3];
  /// Elements lie within the cache: none is fetched before its turn.
  bool within_cache;
};

/// Most pairs of one job.
inline constexpr std::size_t most_measured = 1024;

/// Geometry of contacts in vectors of pairs.
struct MeasureKernels {
  /// Measures whole vectors of pairs from the front and returns how many pairs; the rest is the
  /// caller's. Of those that it treated it lists the pairs whose bits are not certain, which the
  /// caller measures again (exact::gap, exact::distance_vector, exact::CenterLine). `open` has room
  /// for most_measured.
  std::size_t (*measure)(const MeasureJob& job, int dimensions, std::uint32_t* open,
                         std::size_t& open_count);
};

/// `level` must be available.
[[nodiscard]] MeasureKernels measure_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] MeasureKernels simd_measure_kernels(std::int64_t target);

}  // namespace abut::kernels
