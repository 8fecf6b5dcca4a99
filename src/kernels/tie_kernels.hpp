#pragma once

#include "kernels/search_job.hpp"
#include "kernels/strided_spheres.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Elements of hits are fetched so many pairs ahead of their decision: enough to hide the way to
/// memory.
inline constexpr std::size_t hits_fetched_ahead = 32;

/// Decisions about spheres in vectors of pairs.
struct TieKernels {
  /// Decides the undecided pairs of the hits by the first three stages of exact::within_reach,
  /// which are the filter, the filter's operations where nothing rounds, and doubled precision.
  /// Adds to `exact_decisions` what the filter leaves. Treats whole vectors from the front and
  /// returns how many pairs; the rest, and those that stay Verdict::open, are the caller's.
  std::size_t (*decide)(const kernels::StridedSpheres& spheres, int dimensions, double margin,
                        HitBuffer& hits, std::uint64_t& exact_decisions);
};

/// `level` must be available.
[[nodiscard]] TieKernels tie_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] TieKernels simd_tie_kernels(std::int64_t target);

}  // namespace abut::kernels
