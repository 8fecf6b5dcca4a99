#pragma once

#include "periodic/list_ghosts.hpp"

#include <cstddef>

namespace abut::periodic {

/// A bound of how many ghosts there are, coarse by a factor of two: from the widest windows.
template <int Dim>
[[nodiscard]] double most_ghosts(const kernels::StridedSpheres& elements,
                                 const GhostWindows<Dim>& windows) {
  const auto all = static_cast<double>(elements.size);
  const double of_small = windows.of_small.most_images();
  const double of_large = windows.of_large.most_images();
  if (!(of_large > of_small)) return all * of_small;
  double large = 0.0;
  for (std::size_t k = 0; k < elements.size; ++k) {
    if (elements.radius(k) >= windows.cut) large += 1.0;
  }
  return (all - large) * of_small + large * of_large;
}

}  // namespace abut::periodic
