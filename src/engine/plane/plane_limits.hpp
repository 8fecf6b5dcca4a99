#pragma once

#include <cstddef>

namespace abut::engine {

/// What a plane is worth for few elements (PlaneGrid).
struct PlaneLimits {
  /// More are not searched in a plane; and of those with many pairs no more in 2D, where a plane
  /// leaves nothing undivided.
  std::size_t most_spheres = 8'191;
  std::size_t most_boxes = 4'000;
  std::size_t most_with_many_hits_in_2d = 128;
  /// So few are, however they crowd; and the same where the reach is so small a part of their box
  /// that the filter leaves most pairs of a crowd undecided.
  std::size_t always = 256;
  std::size_t always_far_apart = 128;
  double least_reach_of_crowds = 0x1p-16;
  /// Candidates of an element, on average, up to which no other search is faster, as far as can be
  /// told without a look at them; and the same where elements lie so far apart that the filter
  /// leaves many undecided.
  double most_met = 50.0;
  double most_met_far_apart = 1.0;
};

/// No plane for any number.
inline constexpr PlaneLimits no_plane{.most_spheres = 0, .most_boxes = 0};

}  // namespace abut::engine
