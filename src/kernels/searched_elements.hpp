#pragma once

#include "kernels/search_job.hpp"

#include <cstdint>

namespace abut::kernels {

/// Bounds the error of a distance that is computed in single precision, relative to the largest
/// number that enters it (docs/derivations/tile_filter.md).
inline constexpr double filter_error = 0x1p-20;

/// Center of what is no element: far beyond every element, yet with a finite square, so that it is
/// within reach of nothing.
inline constexpr float far_away = 1e18f;

/// Sorted elements in columns of single precision, in a unit in which no number of theirs exceeds
/// 1, but for `far_away`.
struct SearchedElements {
  ElementShape shape;
  const float* center[3];       ///< by axis
  const float* size[3];         ///< as the shape says
  float common_radius;          ///< of equal spheres; of others the largest
  const std::uint32_t* number;  ///< of the element in the caller's arrays
};

/// A larger element that meets these without being sorted among them.
struct CoarseElement {
  float center[3];
  float size[3];  ///< as the shape of the others says, but the radius of a sphere in any case
  float slack;
  std::uint32_t number;
};

}  // namespace abut::kernels
