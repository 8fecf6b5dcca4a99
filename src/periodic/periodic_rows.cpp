#include "periodic/periodic_rows.hpp"

#include "engine/set_search.hpp"
#include "grid/scaling.hpp"
#include "kernels/tie_kernels.hpp"
#include "lattice/check_range.hpp"
#include "lattice/lattice_step.hpp"
#include "lattice/lattice_unit.hpp"
#include "lattice/orthogonal_cell.hpp"
#include "lattice/reduced_lattice.hpp"
#include "lattice/turn_downwards.hpp"
#include "periodic/ghost_cut.hpp"
#include "periodic/move_boxes.hpp"
#include "periodic/periodic_decider.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace abut::periodic {
namespace {

/// The search set that takes locals and ghosts alike; pairs of ghosts are dropped.
template <int Dim>
engine::SearchSet<Dim> set_of_all(const Images<Dim>& images) {
  engine::SearchSet<Dim> set;
  set.locals = engine::Numbers(images.locals().size + images.ghosts().size());
  set.bounds = images.local_bounds();
  set.bounds.include(images.ghost_bounds());
  return set;
}

/// The search set of locals with ghosts that lie around their box, as halo elements do: no more
/// than copies in its outer tiles.
template <int Dim>
engine::SearchSet<Dim> set_with_halo(const exact::Elements<Dim>& moved, const Images<Dim>& images) {
  const std::size_t locals = images.locals().size;
  engine::SearchSet<Dim> set = set_of_all(images);
  if (moved.are_boxes()) set.bounds.count_largest_twice();
  set.locals = engine::Numbers(locals);
  set.halo = engine::Numbers::from(static_cast<std::uint32_t>(locals), images.ghosts().size());
  set.bounds.lower = images.local_bounds().lower;
  set.bounds.upper = images.local_bounds().upper;
  return set;
}

/// Layers take all alike; in tiles ghosts are halo elements where they can be.
template <int Dim>
void search(engine::SetSearch<Dim>& search, const exact::Elements<Dim>& moved,
            const Images<Dim>& images) {
  engine::SearchSet<Dim> all = set_of_all(images);
  if (moved.are_boxes()) all.bounds.count_largest_twice();
  if (!images.ghosts_are_outside()) return search.search(all);
  if (!search.search_in_layers(all)) search.search(set_with_halo(moved, images));
}

/// The steps of which images of spheres are sums that nothing rounds: vectors are multiples as
/// well, and no number has more than 48 bits, since the slack is 2^-48 of the magnitudes at least
/// (docs/derivations/layer_steps.md).
template <int Dim>
engine::GivenSteps steps_of(const kernels::StridedSpheres& spheres, const Images<Dim>& images) {
  if (images.unit() != 1.0) return {};
  return {spheres, images.slack(), lattice::step_of(images.reduced_lattice())};
}

/// Takes the ghosts away again that were appended to elements.
template <int Dim>
class TemporaryGhosts {
 public:
  explicit TemporaryGhosts(base::Array<exact::Sphere<Dim>>& elements)
      : elements_(elements), size_(elements.size()) {}
  ~TemporaryGhosts() { elements_.resize(size_); }

  TemporaryGhosts(const TemporaryGhosts&) = delete;
  TemporaryGhosts& operator=(const TemporaryGhosts&) = delete;

 private:
  base::Array<exact::Sphere<Dim>>& elements_;
  std::size_t size_;
};

/// The elements of a detection, times a unit where the cell is very small (lattice::unit_of).
/// Stand-ins of boxes are made anew: what is half as wide as the smallest number cannot be said as
/// given.
template <int Dim>
class Given {
 public:
  Given(base::Array<exact::Sphere<Dim>>& spheres, std::span<const exact::Box<Dim>> boxes,
        const grid::Bounds<Dim>& bounds, double unit, base::Array<exact::Sphere<Dim>>& enlarged)
      : unit_(unit), spheres_(unit == 1.0 ? spheres : enlarged), bounds_(bounds) {
    if (unit == 1.0) return;
    base::resize_for_overwrite(enlarged, spheres.size());
    bounds_ = {};
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      exact::Sphere<Dim> sphere = spheres[k];
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
  [[nodiscard]] base::Array<exact::Sphere<Dim>>& spheres() const noexcept { return spheres_; }
  [[nodiscard]] const grid::Bounds<Dim>& bounds() const noexcept { return bounds_; }

 private:
  double unit_;
  base::Array<exact::Sphere<Dim>>& spheres_;
  grid::Bounds<Dim> bounds_;
};

template <int Dim>
kernels::StridedSpheres columns_of(std::span<const exact::Sphere<Dim>> packed) {
  return kernels::strided_spheres(packed);
}
template <int Dim>
const kernels::StridedSpheres& columns_of(const kernels::StridedSpheres& spheres) {
  return spheres;
}

/// Finds the images of spheres, or of boxes that they stand for, in an array or where they lie.
template <int Dim, class Spheres>
void find_images(Spheres&& spheres, const grid::Bounds<Dim>& bounds,
                 const lattice::ReducedLattice<Dim>& reduced, ImageSettings settings,
                 PeriodicWorkspace<Dim>& own) {
  if (settings.shape == Shape::sphere) {
    settings.size_cut = choose_ghost_cut<Dim>(columns_of<Dim>(spheres), bounds, reduced,
                                              settings.margin, own.histogram);
  }
  own.images.find(spheres, bounds, reduced, settings);
}

/// True if images are coarse, and none was moved so far, or is so large, that it cannot be placed
/// anew.
template <int Dim>
bool must_be_grown(const Images<Dim>& images, double margin) {
  return images.are_coarse(margin) && images.shifts_always_fit() && images.unit() == 1.0;
}

/// True if images may be made in either direction. Of boxes they reach as far as the widest one
/// where they lie above the locals (lattice::turn_downwards): not far, where that is a small part
/// of the cell.
template <int Dim>
bool may_be_turned(const exact::Elements<Dim>& elements, const grid::Bounds<Dim>& bounds,
                   double margin, const lattice::ReducedLattice<Dim>& lattice) {
  constexpr double small_part = 0.25;
  if (!elements.are_boxes()) return true;
  const double widest = 2.0 * bounds.largest_radius + margin;
  return std::all_of(lattice.height.begin(), lattice.height.begin() + lattice.count,
                     [&](double height) { return widest <= small_part * height; });
}

/// What a search among images is made of, but for the elements themselves.
template <int Dim>
struct PeriodicSearch {
  const engine::RowsSettings& settings;
  engine::Workspace<Dim>& workspace;
  PeriodicWorkspace<Dim>& own;
  base::PairSink& sink;
  base::DetectionContext& context;

  [[nodiscard]] ImageSettings image_settings(Shape shape, double given_unit) const {
    ImageSettings result{settings.margin * given_unit, settings.workers,
                         kernels::image_kernels(settings.simd)};
    result.shape = shape;
    result.least_in_oblique_cell = settings.layers.least_elements_in_oblique_cell;
    result.given_unit = given_unit;
    result.progress = &context.progress;
    return result;
  }

  /// Returns what `search` does with the search of the images that were found.
  template <class Search>
  auto run(const engine::ExactDecider& decider, const engine::GivenSteps& steps,
           Search&& search) const {
    const Images<Dim>& images = own.images;
    start_sink();
    const exact::Elements<Dim> moved{images.locals_and_ghosts(), own.moved_boxes};
    const auto spheres = engine::LayerSpheres<Dim>(
                             {images.locals(), kernels::strided_spheres(images.ghost_spheres())})
                             .standing_for(kernels::strided_boxes<Dim>(own.moved_boxes));
    const auto input =
        input_of(moved, spheres, steps, decider, images.least_cell(), own.image_sink);
    engine::SetSearch<Dim> set_search(input, workspace, settings.workers, context);
    return search(set_search, moved);
  }

  /// Searches the images that were found of packed elements.
  void run_packed(const exact::Elements<Dim>& originals, const exact::Lattice& lattice) const {
    const Images<Dim>& images = own.images;
    const auto columns = kernels::strided_spheres(originals.spheres);
    const auto decider_with = [&](MovedPairs moved) {
      return PeriodicDecider<Dim>(originals, columns, lattice, images, settings.margin,
                                  kernels::tie_kernels(settings.simd), moved);
    };
    const auto decider = decider_with(MovedPairs::decided);
    own.moved_boxes.clear();
    if (must_be_grown(images, settings.margin)) {
      return run_grown(originals, decider_with(MovedPairs::kept), decider);
    }
    const bool are_boxes = originals.are_boxes();
    if (are_boxes) move_boxes<Dim>(originals.boxes, images, settings.workers, own.moved_boxes);
    const auto steps = are_boxes ? engine::GivenSteps{} : steps_of(columns, images);
    run(decider, steps, [&](engine::SetSearch<Dim>& set_search, const auto& moved) {
      periodic::search(set_search, moved, images);
    });
  }

  /// Searches the images that were found, each grown by what its own place is off. The search keeps
  /// pairs of moved elements, which `of_moved` decides.
  void run_grown(const exact::Elements<Dim>& originals, const engine::ExactDecider& decider,
                 const engine::ExactDecider& of_moved) const {
    start_sink();
    own.deciding_sink.start_anew(own.image_sink, own.images, of_moved);
    own.deciding_sink.expect_workers(settings.workers);
    own.grown.place(originals, own.images, settings.workers, context.work);
    const exact::Elements<Dim> grown = own.grown.elements();
    const auto spheres = engine::LayerSpheres<Dim>({kernels::strided_spheres(grown.spheres), {}})
                             .standing_for(kernels::strided_boxes<Dim>(grown.boxes));
    const auto input = input_of(grown, spheres, {}, decider, 0.0, own.deciding_sink);
    engine::SetSearch<Dim> set_search(input, workspace, settings.workers, context);
    engine::SearchSet<Dim> all;
    all.locals = engine::Numbers(grown.size());
    all.bounds = own.grown.bounds();
    set_search.search(all);
    context.exact_decisions += own.deciding_sink.exact_decisions();
  }

 private:
  void start_sink() const {
    own.image_sink.start_anew(sink, own.images, kernels::image_kernels(settings.simd));
    own.image_sink.expect_workers(settings.workers);
  }

  [[nodiscard]] engine::SearchInput<Dim> input_of(const exact::Elements<Dim>& moved,
                                                  const engine::LayerSpheres<Dim>& spheres,
                                                  const engine::GivenSteps& steps,
                                                  const engine::ExactDecider& decider,
                                                  double least_cell,
                                                  base::PairSink& searched_into) const {
    return {moved,
            spheres,
            steps,
            decider,
            settings.margin * own.images.unit(),
            least_cell,
            kernels::tile_kernels(settings.simd),
            kernels::element_kernels(settings.simd),
            kernels::layer_kernels(settings.simd),
            kernels::plane_kernels(settings.simd),
            settings.wide_vectors,
            settings.layers,
            searched_into,
            context.progress};
  }
};

}  // namespace

template <int Dim>
bool periodic_rows(base::Array<exact::Sphere<Dim>>& spheres, const PeriodicInput<Dim>& asked,
                   engine::Workspace<Dim>& workspace, PeriodicWorkspace<Dim>& own,
                   base::PairSink& sink, base::DetectionContext& context) {
  const auto& [boxes, bounds, lattice, settings] = asked;
  const std::size_t locals = spheres.size();
  const TemporaryGhosts<Dim> temporary_ghosts(spheres);
  const double unit = lattice::unit_of<Dim>(lattice, grid::largest_number(bounds, settings.margin));
  const Given<Dim> given(spheres, boxes, bounds, unit, own.enlarged);
  lattice::ReducedLattice<Dim> reduced(unit == 1.0 ? lattice : lattice::times(lattice, unit));
  if (!boxes.empty()) lattice::turn_downwards(reduced);
  const PeriodicSearch<Dim> search_of_all{settings, workspace, own, sink, context};
  const ImageSettings image_settings =
      search_of_all.image_settings(boxes.empty() ? Shape::sphere : Shape::box, unit);
  if (unit != 1.0) {
    // An error names the numbers that were given.
    lattice::check_range<Dim>(spheres, reduced, settings.margin, image_settings.shape, unit);
  }
  find_images<Dim>(given.spheres(), given.bounds(), reduced, image_settings, own);
  if (must_be_grown(own.images, settings.margin) &&
      may_be_turned<Dim>({spheres, boxes}, bounds, settings.margin, reduced) &&
      own.images.turn_towards_origin(reduced)) {
    spheres.resize(locals);
    find_images<Dim>(given.spheres(), given.bounds(), reduced, image_settings, own);
  }

  if (own.images.reach_is_long()) return false;
  search_of_all.run_packed({std::span(spheres).first(locals), boxes}, lattice);
  return true;
}

template <int Dim>
bool periodic_rows_in_place(const kernels::StridedSpheres& spheres, const PeriodicInput<Dim>& asked,
                            engine::Workspace<Dim>& workspace, PeriodicWorkspace<Dim>& own,
                            base::PairSink& sink, base::DetectionContext& context) {
  const auto& [boxes, bounds, lattice, settings] = asked;
  if (lattice::unit_of<Dim>(lattice, grid::largest_number(bounds, settings.margin)) != 1.0) {
    return false;
  }
  const lattice::ReducedLattice<Dim> reduced(lattice);
  const PeriodicSearch<Dim> search_of_all{settings, workspace, own, sink, context};
  find_images<Dim>(spheres, bounds, reduced, search_of_all.image_settings(Shape::sphere, 1.0), own);

  const Images<Dim>& images = own.images;
  if (images.reach_is_long() || !images.shifts_always_fit()) return false;
  if (must_be_grown(images, settings.margin)) return false;
  own.moved_boxes.clear();
  const PeriodicDecider<Dim> decider({}, spheres, lattice, images, settings.margin,
                                     kernels::tie_kernels(settings.simd));
  const auto steps = steps_of(spheres, images);
  const auto search_images = [&](engine::SetSearch<Dim>& set_search, const auto& moved) {
    if (moved.size() == 0) return set_search.search_in_layers(set_of_all(images));
    search(set_search, moved, images);
    return true;
  };
  return search_of_all.run(decider, steps, search_images);
}

template bool periodic_rows(base::Array<exact::Sphere<2>>&, const PeriodicInput<2>&,
                            engine::Workspace<2>&, PeriodicWorkspace<2>&, base::PairSink&,
                            base::DetectionContext&);
template bool periodic_rows(base::Array<exact::Sphere<3>>&, const PeriodicInput<3>&,
                            engine::Workspace<3>&, PeriodicWorkspace<3>&, base::PairSink&,
                            base::DetectionContext&);
template bool periodic_rows_in_place(const kernels::StridedSpheres&, const PeriodicInput<2>&,
                                     engine::Workspace<2>&, PeriodicWorkspace<2>&, base::PairSink&,
                                     base::DetectionContext&);
template bool periodic_rows_in_place(const kernels::StridedSpheres&, const PeriodicInput<3>&,
                                     engine::Workspace<3>&, PeriodicWorkspace<3>&, base::PairSink&,
                                     base::DetectionContext&);

}  // namespace abut::periodic
