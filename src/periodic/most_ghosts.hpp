#pragma once

#include "periodic/list_ghosts.hpp"

#include <algorithm>
#include <span>

namespace abut::periodic {

/// A bound of how many ghosts there are, coarse by a factor of two: from the widest windows.
template <int Dim>
[[nodiscard]] double most_ghosts(std::span<const exact::Sphere<Dim>> elements,
                                 const GhostWindows<Dim>& windows) {
  const auto all = static_cast<double>(elements.size());
  const double of_small = windows.of_small.most_images();
  const double of_large = windows.of_large.most_images();
  if (!(of_large > of_small)) return all * of_small;
  const auto large = static_cast<double>(std::count_if(
      elements.begin(), elements.end(),
      [&](const exact::Sphere<Dim>& sphere) { return sphere.radius >= windows.cut; }));
  return (all - large) * of_small + large * of_large;
}

}  // namespace abut::periodic
