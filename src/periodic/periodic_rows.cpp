#include "periodic/periodic_rows.hpp"

#include "engine/group_search.hpp"
#include "lattice/brick.hpp"
#include "lattice/reduced_lattice.hpp"
#include "periodic/ghost_cut.hpp"
#include "periodic/move_boxes.hpp"
#include "periodic/periodic_arbiter.hpp"

namespace abut::engine {
namespace {

/// With so many ghosts for each native the reach is about as long as the cell or longer, and a
/// native is within reach of a good part of them: no grid would help.
constexpr std::size_t ghosts_of_long_reach = 16;

/// Makes every side of the brick lead against the axes of space, rather than along them: images
/// along it, of which ghosts are made, are then within reach of natives as far as they are wide
/// themselves. In the other direction it would be as far as the widest native is, and one wide wall
/// would make ghosts of all elements.
template <int Dim>
void turn_downwards(grid::ReducedLattice<Dim>& lattice) {
  if (lattice.count == 0) return;
  const grid::Brick<Dim> brick(lattice, 1.0);
  for (std::size_t k = 0; k < brick.count; ++k) {
    if (brick.rise[k] > brick.fall[k]) lattice.turn(brick.vector_of[k]);
  }
}

/// Where ghosts lie around the box of the natives, as foreigns do, they are no more than copies in
/// its outer tiles. Elsewhere the search takes all alike, and pairs of ghosts are dropped.
template <int Dim>
Group<Dim> group_of(const Images<Dim>& images) {
  const std::size_t natives = images.natives().size();
  const std::size_t ghosts = images.ghosts().size();
  Group<Dim> group;
  group.bounds = images.native_bounds();
  group.bounds.include(images.ghost_bounds());
  if (!images.ghosts_are_outside()) {
    group.natives = Numbers(natives + ghosts);
    return group;
  }
  group.natives = Numbers(natives);
  group.foreigns = Numbers::from(static_cast<std::uint32_t>(natives), ghosts);
  group.bounds.lower = images.native_bounds().lower;
  group.bounds.upper = images.native_bounds().upper;
  return group;
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

/// Takes the ghosts away again that were appended to elements.
template <int Dim>
class Appendix {
 public:
  explicit Appendix(base::Array<base::Sphere<Dim>>& elements)
      : elements_(elements), size_(elements.size()) {}
  ~Appendix() { elements_.resize(size_); }

  Appendix(const Appendix&) = delete;
  Appendix& operator=(const Appendix&) = delete;

 private:
  base::Array<base::Sphere<Dim>>& elements_;
  std::size_t size_;
};

}  // namespace

template <int Dim>
void periodic_rows(base::Array<base::Sphere<Dim>>& spheres, std::span<const base::Box<Dim>> boxes,
                   const grid::Bounds<Dim>& bounds, const base::Lattice& lattice,
                   const RowsSettings& settings, Workspace<Dim>& workspace,
                   PeriodicWorkspace<Dim>& own, base::PairSink& sink,
                   base::DetectionContext& context) {
  const std::size_t natives = spheres.size();
  const Appendix<Dim> appendix(spheres);
  grid::ReducedLattice<Dim> reduced(lattice);
  if (!boxes.empty()) turn_downwards(reduced);
  Images<Dim>& images = own.images;
  const kernels::ImageKernels kernels = kernels::image_kernels(settings.simd);
  ImageSettings image_settings{settings.margin, settings.workers, kernels};
  if (boxes.empty()) {
    image_settings.size_cut =
        choose_ghost_cut<Dim>(spheres, bounds, reduced, settings.margin, own.histogram);
  } else {
    image_settings.shape = Shape::box;
  }
  images.find(spheres, bounds, reduced, image_settings);

  ImageSink<Dim>& image_sink = own.image_sink;
  image_sink.start_anew(sink, images, kernels);
  image_sink.expect_workers(settings.workers);
  const base::Elements<Dim> originals{std::span(spheres).first(natives), boxes};
  const PeriodicArbiter<Dim> arbiter(originals, lattice, images, settings.margin);
  const bool long_reach = images.ghosts().size() > ghosts_of_long_reach * natives;
  own.moved_boxes.clear();
  if (!boxes.empty() && !long_reach) {
    move_boxes<Dim>(boxes, images, settings.workers, own.moved_boxes);
  }
  const Task<Dim> task{{images.natives_and_ghosts(), own.moved_boxes},
                       arbiter,
                       settings.margin * images.unit(),
                       images.least_cell(),
                       kernels::tile_kernels(settings.simd),
                       kernels::element_kernels(settings.simd),
                       image_sink,
                       context.progress};
  if (long_reach) return check_all(task, natives, context);
  Group<Dim> group = group_of(images);
  if (!boxes.empty()) group.bounds.count_largest_twice();
  GroupSearch<Dim>(task, workspace, settings.workers, context).search(group);
}

template void periodic_rows(base::Array<base::Sphere<2>>&, std::span<const base::Box<2>>,
                            const grid::Bounds<2>&, const base::Lattice&, const RowsSettings&,
                            Workspace<2>&, PeriodicWorkspace<2>&, base::PairSink&,
                            base::DetectionContext&);
template void periodic_rows(base::Array<base::Sphere<3>>&, std::span<const base::Box<3>>,
                            const grid::Bounds<3>&, const base::Lattice&, const RowsSettings&,
                            Workspace<3>&, PeriodicWorkspace<3>&, base::PairSink&,
                            base::DetectionContext&);

}  // namespace abut::engine
