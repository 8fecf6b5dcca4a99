#pragma once

#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "periodic/list_ghosts.hpp"

#include <array>
#include <span>

namespace abut::periodic {

/// Bounds of some ghosts.
template <int Dim>
struct GhostPlaces {
  grid::Bounds<Dim> bounds;

  /// True if each lies strictly outside of the locals' box.
  bool all_outside = true;

  void include(const GhostPlaces& others) noexcept {
    bounds.include(others.bounds);
    all_outside = all_outside && others.all_outside;
  }
};

/// spheres[g] = the image of a local element that is ghosts[g]; `steps` are the vectors of the
/// sides, 0 where there are fewer sides than axes. Asks `progress`, if there is one, now and then.
template <int Dim>
[[nodiscard]] GhostPlaces<Dim> place_ghosts(std::span<const Ghost> ghosts,
                                            const kernels::StridedSpheres& locals,
                                            const std::array<std::array<double, Dim>, Dim>& steps,
                                            const grid::Bounds<Dim>& box_of_locals,
                                            std::span<exact::Sphere<Dim>> spheres,
                                            base::ProgressReporter* progress);

}  // namespace abut::periodic
