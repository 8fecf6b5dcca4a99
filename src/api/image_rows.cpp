// Let R be the reach of two elements and e the slack of grid::Images: where one of them was moved
// their distance, here, is off by at most e. So the search must reach R + e.
//
// Where all natives are in place, e goes into the radii of the ghosts, and the search decides about
// natives on the caller's numbers. Otherwise e goes into the margin, so that radii that are equal
// stay so. What was found with a reach of R + e is decided again in ImageSink.

#include "api/image_rows.hpp"

#include "base/workers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace abut::api {
namespace {

double longer(double length, double slack) {
  return std::nextafter(length + slack, std::numeric_limits<double>::infinity());
}

}  // namespace

template <int Dim>
void ImageRows<Dim>::place_all(double ghost_slack, std::size_t workers) {
  const auto natives = images_.natives();
  const auto ghosts = images_.ghosts();
  if (all_.capacity() < natives.size() + ghosts.size()) all_.clear();
  all_.resize(natives.size() + ghosts.size());
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, natives.size());
    std::copy(natives.begin() + static_cast<std::ptrdiff_t>(first),
              natives.begin() + static_cast<std::ptrdiff_t>(last),
              all_.begin() + static_cast<std::ptrdiff_t>(first));
  });
  bounds_ = images_.bounds();
  for (std::size_t k = 0; k < ghosts.size(); ++k) {
    base::Sphere<Dim> sphere = images_.sphere_of(ghosts[k]);
    if (ghost_slack > 0.0) sphere.radius = longer(sphere.radius, ghost_slack);
    bounds_.include_center(sphere);
    bounds_.include_radius(sphere.radius);
    all_[natives.size() + k] = sphere;
  }
}

template <int Dim>
void ImageRows<Dim>::search(std::span<const base::Sphere<Dim>> spheres,
                            const grid::Bounds<Dim>& bounds, const base::Lattice& lattice,
                            const engine::RowsSettings& settings, engine::Workspace<Dim>& workspace,
                            base::PairSink& sink, base::DetectionContext& context) {
  const grid::ReducedLattice<Dim> reduced(lattice);
  images_.find(spheres, bounds, reduced, settings.margin, settings.workers);
  const bool all_in_place = images_.natives().data() == spheres.data();
  engine::RowsSettings in_open_space = settings;
  if (!all_in_place) {
    in_open_space.margin = longer(settings.margin * images_.unit(), images_.slack());
  }
  place_all(all_in_place ? images_.slack() : 0.0, settings.workers);
  const ImageSystem<Dim> system{images_, spheres, lattice, settings.margin};
  sink_.start_anew(system, sink);
  engine::rows<Dim>(all_, bounds_, in_open_space, workspace, sink_, context);
  context.exact_decisions += sink_.exact_decisions();
}

template class ImageRows<2>;
template class ImageRows<3>;

}  // namespace abut::api
