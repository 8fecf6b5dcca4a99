#include "engine/periodic_rows.hpp"

#include "engine/arbiter.hpp"
#include "engine/group_search.hpp"
#include "grid/reduced_lattice.hpp"

namespace abut::engine {
namespace {

/// Natives and ghosts are a little off where they were moved. In cells of so many times that error
/// it is a sixteenth of the filter's slack (docs/derivations/tile_filter.md, section 3).
constexpr double cells_of_error = 0x1p24;

/// With so many ghosts for each native the reach is about as long as the cell or longer, and a
/// native is within reach of a good part of them: no grid would help.
constexpr std::size_t ghosts_of_long_reach = 16;

/// Natives, then ghosts.
template <int Dim>
grid::Bounds<Dim> list_all(const grid::Images<Dim>& images, base::Array<base::Sphere<Dim>>& all) {
  base::make_room(all, images.natives().size() + images.ghosts().size());
  auto end = std::copy(images.natives().begin(), images.natives().end(), all.begin());
  grid::Bounds<Dim> bounds = images.bounds();
  for (const grid::Ghost& ghost : images.ghosts()) {
    *end = images.sphere_of(ghost);
    bounds.include_center(*end);
    bounds.include_radius(end->radius);
    ++end;
  }
  return bounds;
}

/// Every native against the natives behind it and every ghost, each decided on the caller's
/// numbers.
template <int Dim>
void check_all(const Task<Dim>& task, std::size_t natives, base::DetectionContext& context) {
  base::PairWriter pairs(task.sink);
  const auto all = static_cast<std::uint32_t>(task.elements.size());
  for (std::uint32_t i = 0; i < natives; ++i) {
    context.progress.at(i);
    context.candidate_tests += all - i - 1;
    for (std::uint32_t other = i + 1; other < all; ++other) {
      if (task.arbiter.within_reach(i, other, context.exact_decisions)) pairs.push({i, other});
    }
  }
  pairs.finish();
}

}  // namespace

template <int Dim>
void periodic_rows(std::span<const base::Sphere<Dim>> spheres, const grid::Bounds<Dim>& bounds,
                   const base::Lattice& lattice, const RowsSettings& settings,
                   Workspace<Dim>& workspace, base::PairSink& sink,
                   base::DetectionContext& context) {
  const grid::ReducedLattice<Dim> reduced(lattice);
  grid::Images<Dim>& images = workspace.images;
  images.find(spheres, bounds, reduced, settings.margin, settings.workers);

  ImageSink<Dim>& image_sink = workspace.image_sink;
  image_sink.start_anew(sink, images);
  image_sink.expect_workers(settings.workers);
  const PeriodicArbiter<Dim> arbiter(spheres, lattice, images, settings.margin);
  Group<Dim> group;
  group.bounds = list_all(images, workspace.natives_and_ghosts);
  group.natives = Numbers(images.natives().size() + images.ghosts().size());
  const auto all =
      std::span<const base::Sphere<Dim>>(workspace.natives_and_ghosts).first(group.natives.size());
  const Task<Dim> task{{all, {}},
                       arbiter,
                       settings.margin * images.unit(),
                       images.slack() * cells_of_error,
                       kernels::tile_kernels(settings.simd),
                       kernels::element_kernels(settings.simd),
                       image_sink,
                       context.progress};
  if (images.ghosts().size() > ghosts_of_long_reach * spheres.size()) {
    return check_all(task, spheres.size(), context);
  }
  GroupSearch<Dim>(task, workspace, settings.workers, context).search(group);
}

template void periodic_rows(std::span<const base::Sphere<2>>, const grid::Bounds<2>&,
                            const base::Lattice&, const RowsSettings&, Workspace<2>&,
                            base::PairSink&, base::DetectionContext&);
template void periodic_rows(std::span<const base::Sphere<3>>, const grid::Bounds<3>&,
                            const base::Lattice&, const RowsSettings&, Workspace<3>&,
                            base::PairSink&, base::DetectionContext&);

}  // namespace abut::engine
