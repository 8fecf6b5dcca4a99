#include "periodic/periodic_rows.hpp"

#include "engine/group_search.hpp"
#include "lattice/brick.hpp"
#include "lattice/check_range.hpp"
#include "lattice/lattice_unit.hpp"
#include "lattice/reduced_lattice.hpp"
#include "periodic/ghost_cut.hpp"
#include "periodic/move_boxes.hpp"
#include "periodic/periodic_arbiter.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::engine {
namespace {

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

/// Every native against the natives behind it, and against every ghost, which is not stored: each
/// decided on the caller's numbers. Pairs are handed on as they are found, so that limits of their
/// number and of memory are met early.
template <int Dim>
class LongReach {
 public:
  LongReach(const base::Elements<Dim>& elements, const base::Lattice& lattice, double margin,
            const Images<Dim>& images, base::PairSink& sink, base::DetectionContext& context)
      : elements_(elements),
        lattice_(lattice),
        margin_(margin),
        images_(images),
        pairs_(sink),
        context_(context) {}

  void search() {
    const auto count = static_cast<std::uint32_t>(elements_.size());
    for (std::uint32_t j = 0; j < count; ++j) {
      context_.progress.at(j);
      for (std::uint32_t i = 0; i < j; ++i) decide(i, j, images_.shift_between(i, j));
      images_.for_each_ghost_of(j, [&](const Ghost& ghost) {
        for (std::uint32_t i = 0; i < count; ++i) {
          if (images_.counts(i, ghost)) decide(i, j, images_.shift_between(i, ghost));
        }
      });
    }
    pairs_.finish();
  }

 private:
  static constexpr std::uint64_t tests_between_polls = 1 << 18;

  void decide(std::uint32_t i, std::uint32_t j, const ImageShift& shift) {
    if (++context_.candidate_tests % tests_between_polls == 0) context_.progress.poll();
    if (!elements_.within_reach(i, j, shift, lattice_, margin_, context_.exact_decisions)) return;
    const bool in_order = i < j || (i == j && ImageShift{} < shift);
    pairs_.push({std::min(i, j), std::max(i, j)},
                in_order ? shift : ImageShift{-shift.x, -shift.y, -shift.z});
  }

  base::Elements<Dim> elements_;
  const base::Lattice& lattice_;
  double margin_;
  const Images<Dim>& images_;
  base::ImagePairWriter pairs_;
  base::DetectionContext& context_;
};

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

/// The elements of a detection, times a unit where the cell is very small (grid::unit_of).
/// Stand-ins of boxes are made anew: what is half as wide as the smallest number cannot be said as
/// given.
template <int Dim>
class Given {
 public:
  Given(base::Array<base::Sphere<Dim>>& spheres, std::span<const base::Box<Dim>> boxes,
        const grid::Bounds<Dim>& bounds, double unit, base::Array<base::Sphere<Dim>>& enlarged)
      : unit_(unit), spheres_(unit == 1.0 ? spheres : enlarged), bounds_(bounds) {
    if (unit == 1.0) return;
    base::resize_for_overwrite(enlarged, spheres.size());
    bounds_ = {};
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      base::Sphere<Dim> sphere = spheres[k];
      for (double& x : sphere.center) x *= unit;
      sphere.radius *= unit;
      for (std::size_t axis = 0; axis < Dim && !boxes.empty(); ++axis) {
        const double width = boxes[k].upper[axis] * unit - boxes[k].lower[axis] * unit;
        sphere.radius = std::max(sphere.radius, 0.5 * width);
      }
      enlarged[k] = sphere;
      bounds_.include_center(sphere);
      bounds_.include_radius(sphere.radius);
    }
    if (!boxes.empty()) bounds_.count_largest_twice();
  }

  [[nodiscard]] double unit() const noexcept { return unit_; }
  [[nodiscard]] base::Array<base::Sphere<Dim>>& spheres() const noexcept { return spheres_; }
  [[nodiscard]] const grid::Bounds<Dim>& bounds() const noexcept { return bounds_; }

 private:
  double unit_;
  base::Array<base::Sphere<Dim>>& spheres_;
  grid::Bounds<Dim> bounds_;
};

template <int Dim>
void find_images(const Given<Dim>& given, const base::Elements<Dim>& originals,
                 const grid::ReducedLattice<Dim>& reduced, const RowsSettings& settings,
                 const kernels::ImageKernels& kernels, PeriodicWorkspace<Dim>& own,
                 base::ProgressReporter& progress) {
  ImageSettings image_settings{settings.margin * given.unit(), settings.workers, kernels};
  image_settings.given_unit = given.unit();
  image_settings.progress = &progress;
  if (originals.are_boxes()) {
    image_settings.shape = Shape::box;
  } else {
    image_settings.size_cut = choose_ghost_cut<Dim>(given.spheres(), given.bounds(), reduced,
                                                    image_settings.margin, own.histogram);
  }
  if (given.unit() != 1.0) {
    // An error names the numbers that were given.
    grid::check_range<Dim>(originals.spheres, reduced, settings.margin, image_settings.shape,
                           given.unit());
  }
  own.images.find(given.spheres(), given.bounds(), reduced, image_settings);
}

}  // namespace

template <int Dim>
void periodic_rows(base::Array<base::Sphere<Dim>>& spheres, std::span<const base::Box<Dim>> boxes,
                   const grid::Bounds<Dim>& bounds, const base::Lattice& lattice,
                   const RowsSettings& settings, Workspace<Dim>& workspace,
                   PeriodicWorkspace<Dim>& own, base::PairSink& sink,
                   base::DetectionContext& context) {
  const std::size_t natives = spheres.size();
  const Appendix<Dim> appendix(spheres);
  const double unit = grid::unit_of<Dim>(lattice, grid::largest_number(bounds, settings.margin));
  const Given<Dim> given(spheres, boxes, bounds, unit, own.enlarged);
  grid::ReducedLattice<Dim> reduced(unit == 1.0 ? lattice : grid::times(lattice, unit));
  if (!boxes.empty()) turn_downwards(reduced);
  const kernels::ImageKernels kernels = kernels::image_kernels(settings.simd);
  find_images(given, {spheres, boxes}, reduced, settings, kernels, own, context.progress);

  const Images<Dim>& images = own.images;
  const base::Elements<Dim> originals{std::span(spheres).first(natives), boxes};
  if (images.reach_is_long()) {
    sink.expect_workers(settings.workers);
    return LongReach<Dim>(originals, lattice, settings.margin, images, sink, context).search();
  }
  own.image_sink.start_anew(sink, images, kernels);
  own.image_sink.expect_workers(settings.workers);
  const PeriodicArbiter<Dim> arbiter(originals, lattice, images, settings.margin);
  own.moved_boxes.clear();
  if (!boxes.empty()) move_boxes<Dim>(boxes, images, settings.workers, own.moved_boxes);
  const Task<Dim> task{{images.natives_and_ghosts(), own.moved_boxes},
                       arbiter,
                       settings.margin * images.unit(),
                       images.least_cell(),
                       kernels::tile_kernels(settings.simd),
                       kernels::element_kernels(settings.simd),
                       own.image_sink,
                       context.progress};
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
