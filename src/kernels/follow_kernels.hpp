#pragma once

#include "kernels/candidate_kernels.hpp"
#include "kernels/element_kernels.hpp"

#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Spheres in columns, where they were then (their anchors, as records), and the slots that they go
/// to.
struct FollowedSpheres {
  ElementColumns now;
  const double* anchors;
  std::size_t count;
  QuantumSphere* slots;
  QuantumScale scale;
};

/// The two largest ways of elements since they were anchored, the growth of their radii included,
/// each made longer by what the computation may have lost.
struct LongestTwo {
  double first = 0.0;
  double second = 0.0;
};

/// Relative error of the sum of a displacement and a growth, computed with half a dozen roundings:
/// at most 16 u.
inline constexpr double displacement_band = 0x1p-49;

/// Ways with smaller squares are shorter than one that is known: `displacement_band` makes them
/// longer by less than 2^-48, and 2^-40 off the square is 2^-41 off the way.
[[nodiscard]] inline double negligible_square(double known_way) noexcept {
  return known_way * known_way * (1.0 - 0x1p-40);
}

struct FollowKernels {
  /// Measures the ways of spheres and fills their slots. Treats whole vectors from the front and
  /// returns how many spheres; stops before a vector that holds an invalid sphere, or one whose way
  /// cannot be squared. The rest is the caller's, who has the same in plain C++.
  std::size_t (*follow)(const FollowedSpheres& spheres, int dimensions, LongestTwo& longest);
};

/// `level` must be available.
[[nodiscard]] FollowKernels follow_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] FollowKernels simd_follow_kernels(std::int64_t target);

}  // namespace abut::kernels
