#include "periodic/place_ghosts.hpp"

#include <algorithm>
#include <cstddef>

namespace abut::periodic {
namespace {

template <int Dim>
bool is_outside(const exact::Sphere<Dim>& sphere, const grid::Bounds<Dim>& box) {
  bool outside = false;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    outside |= sphere.center[axis] < box.lower[axis] || sphere.center[axis] > box.upper[axis];
  }
  return outside;
}

}  // namespace

template <int Dim>
GhostPlaces<Dim> place_ghosts(std::span<const Ghost> ghosts, const kernels::StridedSpheres& locals,
                              const std::array<std::array<double, Dim>, Dim>& steps,
                              const grid::Bounds<Dim>& box_of_locals,
                              std::span<exact::Sphere<Dim>> spheres,
                              base::ProgressReporter* progress) {
  constexpr std::size_t locals_fetched_ahead = 16;  // enough to hide the way to memory
  constexpr std::size_t ghosts_between_polls = std::size_t{1} << 18;
  GhostPlaces<Dim> places;
  for (std::size_t g = 0; g < ghosts.size(); ++g) {
    const Ghost& later = ghosts[std::min(g + locals_fetched_ahead, ghosts.size() - 1)];
    kernels::fetch<Dim>(locals, later.element);
    exact::Sphere<Dim> sphere = kernels::sphere_at<Dim>(locals, ghosts[g].element);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      for (std::size_t k = 0; k < Dim; ++k) {
        sphere.center[axis] += ghosts[g].image[k] * steps[k][axis];
      }
    }
    places.bounds.include_center(sphere);
    places.bounds.include_radius(sphere.radius);
    places.all_outside = places.all_outside && is_outside(sphere, box_of_locals);
    spheres[g] = sphere;
    if (progress != nullptr && (g + 1) % ghosts_between_polls == 0) progress->poll();
  }
  return places;
}

template GhostPlaces<2> place_ghosts<2>(std::span<const Ghost>, const kernels::StridedSpheres&,
                                        const std::array<std::array<double, 2>, 2>&,
                                        const grid::Bounds<2>&, std::span<exact::Sphere<2>>,
                                        base::ProgressReporter*);
template GhostPlaces<3> place_ghosts<3>(std::span<const Ghost>, const kernels::StridedSpheres&,
                                        const std::array<std::array<double, 3>, 3>&,
                                        const grid::Bounds<3>&, std::span<exact::Sphere<3>>,
                                        base::ProgressReporter*);

}  // namespace abut::periodic
