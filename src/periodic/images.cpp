#include "periodic/images.hpp"

#include "base/workers.hpp"
#include "grid/scaling.hpp"
#include "lattice/check_range.hpp"
#include "lattice/lattice_unit.hpp"
#include "lattice/oblique_cell.hpp"
#include "lattice/wrap_rules.hpp"
#include "periodic/most_ghosts.hpp"
#include "periodic/place_locals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace abut::periodic {
namespace {

/// Relative to the magnitude (docs/derivations/periodic_images.md, 4).
constexpr double slack_of_fast_wraps = 2.0 * lattice::slack_of_ghosts;

/// Number of locals between two questions to the hook: no small part of a detection.
constexpr std::size_t locals_between_polls = 512 * kernels::BlockList::room;

/// Gives the array a size with values of any kind, without a copy if it must grow.
template <class T>
void overwrite(base::Array<T>& array, std::size_t size, std::size_t room) {
  if (array.capacity() < size) {
    array.clear();
    array.reserve(room);
  }
  array.resize(size);
}

template <int Dim>
void require_narrow_windows(std::size_t sides, const GhostWindows<Dim>& windows) {
  for (std::size_t k = 0; k < sides; ++k) {
    lattice::require_narrow_window(windows.of_large.most_cells(k));
  }
}

}  // namespace

template <int Dim>
Images<Dim>::Images(base::MemoryMeter& memory)
    : memory_(memory),
      own_spheres_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      cells_moved_(memory),
      own_ghosts_(base::make_array_for_overwrite<Ghost>(memory, 0)) {}

template <int Dim>
void Images<Dim>::find(base::Array<exact::Sphere<Dim>>& elements, const grid::Bounds<Dim>& bounds,
                       const lattice::ReducedLattice<Dim>& lattice, const ImageSettings& settings) {
  start_anew(kernels::strided_spheres<Dim>(elements), bounds, lattice, settings);
  are_packed_ = true;
  locals_and_ghosts_ = elements;
  find_with({elements, elements.size()}, settings);
}

template <int Dim>
void Images<Dim>::find(const kernels::StridedSpheres& elements, const grid::Bounds<Dim>& bounds,
                       const lattice::ReducedLattice<Dim>& lattice, const ImageSettings& settings) {
  start_anew(elements, bounds, lattice, settings);
  are_packed_ = false;
  find_with({own_spheres_, 0}, settings);
}

/// Finds the images of the elements as given. If none must be moved, the array for their ghosts is
/// the one that is given with them.
template <int Dim>
void Images<Dim>::find_with(const GhostArray& given, const ImageSettings& settings) {
  const lattice::ReducedLattice<Dim>& lattice = *lattice_;
  if (given_.size == 0 || lattice.count == 0) return;
  const lattice::OrthogonalCell<Dim> orthogonal_cell(lattice, 1.0);
  take(orthogonal_cell, extent_in(orthogonal_cell, settings));
  const lattice::Reaches reaches{bounds_.largest_radius, settings.margin, settings.shape};
  const Windows windows(lattice, orthogonal_cell, extent_, reaches, settings.size_cut, 1.0);
  is_in_range_ = lattice::is_in_range(orthogonal_cell, extent_, windows.of_large);
  if (!is_in_range_) check_range(given, settings);
  const Along along = lattice::sides_to_wrap<Dim>(orthogonal_cell, extent_, windows.of_large);
  moved_any_ = std::count(along.begin(), along.end(), true) > 0;
  if (!moved_any_ && unit_ == 1.0) {
    slack_ = lattice::slack_of_ghosts * magnitude_of(windows.of_large, along, settings.shape);
    return add_ghosts(given, {orthogonal_cell, windows, {}, false}, settings);
  }
  if (find_in_oblique_cell(given, settings)) return;
  overwrite(own_spheres_, given_.size, given_.size + given_.size / 8);
  locals_ = kernels::strided_spheres<Dim>(own_spheres_);
  if (unit_ == 1.0) {
    const WrapEstimate<Dim> wrap_estimate(lattice, orthogonal_cell, extent_, along);
    const Windows after(lattice, orthogonal_cell, wrap_estimate.extent, reaches, settings.size_cut,
                        1.0);
    if (wrap_fast_if_near(wrap_estimate, {orthogonal_cell, after, along, true}, settings)) return;
  }
  // What lies around the origin is known best, and stays together there.
  const bool stays_together = is_in_range_ && !is_covered_by_cells(slack_, settings.margin);
  wrap_exactly(orthogonal_cell, along, stays_together ? -0.5 : 0.0, settings.workers);
  const lattice::OrthogonalCell<Dim> scaled_orthogonal_cell(lattice, unit_);
  const lattice::Reaches scaled{reaches.largest_radius * unit_, settings.margin * unit_,
                                settings.shape};
  const Windows after(lattice, scaled_orthogonal_cell, extent_, scaled, size_cut_, unit_);
  slack_ = lattice::slack_of_ghosts * magnitude_of(after.of_large, along, settings.shape);
  add_ghosts({own_spheres_, given_.size}, {scaled_orthogonal_cell, after, {}, false}, settings);
}

/// Finds the images where enough spheres lie in one cell of the vectors themselves, so that none
/// must be moved. Returns false where they do not, as some of them show if they lie anywhere, or
/// where it is so far away that rounding would make cells larger than the reach asks for; nothing
/// has changed then.
template <int Dim>
bool Images<Dim>::find_in_oblique_cell(const GhostArray& given, const ImageSettings& settings) {
  constexpr std::size_t samples = 64;
  if (unit_ != 1.0 || lattice_->count < Dim || settings.shape != Shape::sphere) return false;
  if (given_.size < settings.least_in_oblique_cell) return false;
  const lattice::ObliqueCell<Dim> cell(*lattice_, 1.0);
  const lattice::Reaches reaches{bounds_.largest_radius, settings.margin, settings.shape};
  const auto windows_around = [&](const lattice::CellExtent<Dim>& extent) {
    return Windows(*lattice_, cell, extent, reaches, settings.size_cut, 1.0);
  };
  const auto is_one_cell = [&](const lattice::CellExtent<Dim>& extent) {
    const Windows windows = windows_around(extent);
    const Along along = lattice::sides_to_wrap<Dim>(cell, extent, windows.of_large);
    return std::count(along.begin(), along.end(), true) == 0 &&
           lattice::is_in_range<Dim>(cell, extent, windows.of_large);
  };
  const auto sample = [&](std::size_t k) {
    return kernels::sphere_at<Dim>(given_, k * (given_.size - 1) / samples);
  };
  if (!is_one_cell(lattice::extent_of<Dim>(samples, sample, cell))) return false;
  const lattice::CellExtent<Dim> extent = extent_in(cell, settings);
  if (!is_one_cell(extent)) return false;
  const Windows windows = windows_around(extent);
  const auto steps = lattice::side_steps<Dim>(*lattice_, cell, unit_);
  const double slack = lattice::slack_of_ghosts *
                       lattice::magnitude_of<Dim>(extent, windows.of_large, {}, steps, 0.0);
  if (!is_covered_by_cells(slack, settings.margin)) return false;
  take(cell, extent);
  slack_ = slack;
  moved_any_ = false;
  add_ghosts(given, {cell, windows, {}, false}, settings);
  return true;
}

/// True if a search needs no larger cells for that slack than for its reach.
template <int Dim>
bool Images<Dim>::is_covered_by_cells(double slack, double margin) const {
  return slack * lattice::cells_of_error <=
         bounds_.largest_radius + bounds_.second_largest_radius + margin;
}

template <int Dim>
void Images<Dim>::start_anew(const kernels::StridedSpheres& elements,
                             const grid::Bounds<Dim>& bounds,
                             const lattice::ReducedLattice<Dim>& lattice,
                             const ImageSettings& settings) {
  while (parts_.size() < settings.workers) parts_.emplace_back(memory_);
  lattice_ = &lattice;
  given_ = elements;
  locals_ = elements;
  ghost_spheres_ = {};
  locals_and_ghosts_ = {};
  ghosts_ = {};
  bounds_ = bounds;
  places_ = {};
  steps_ = {};
  unit_ = lattice::unit_of_moved(lattice, grid::largest_number(bounds, settings.margin));
  given_unit_ = settings.given_unit;
  size_cut_ = settings.size_cut * unit_;
  slack_ = 0.0;
  reach_is_long_ = false;
  moved_any_ = false;
  cells_moved_at_most_ = {};
  shifts_always_fit_ = true;
  is_in_range_ = true;
}

/// Locals have that extent in that cell from here on.
template <int Dim>
void Images<Dim>::take(const lattice::CellSides<Dim>& cell,
                       const lattice::CellExtent<Dim>& extent) {
  vector_of_ = cell.vector_of;
  steps_ = lattice::side_steps<Dim>(*lattice_, cell, unit_);
  extent_ = extent;
}

/// The extent of the elements as given.
template <int Dim>
lattice::CellExtent<Dim> Images<Dim>::extent_in(const lattice::CellSides<Dim>& cell,
                                                const ImageSettings& settings) {
  if (cell.is_aligned()) return lattice::extent_of(bounds_, cell);
  const std::size_t workers = settings.workers;
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, given_.size);
    parts_[worker].extent =
        extent_of<Dim>(given_, first, last - first, cell, bounds_, settings.kernels);
  });
  lattice::CellExtent<Dim> extent;
  for (std::size_t worker = 0; worker < workers; ++worker) extent.include(parts_[worker].extent);
  return extent;
}

template <int Dim>
bool Images<Dim>::turn_towards_origin(lattice::ReducedLattice<Dim>& lattice) const {
  constexpr double clearly = 0.5;  // in sides: of a cell around the origin either is as good
  if (!is_in_range_) return false;
  bool turned = false;
  for (std::size_t k = 0; k < lattice.count; ++k) {
    if (extent_.lower[k] + extent_.upper[k] <= clearly) continue;
    lattice.turn(vector_of_[k]);
    turned = true;
  }
  return turned;
}

/// Looks at each element, since bounds do not tell whether all are in range.
template <int Dim>
void Images<Dim>::check_range(const GhostArray& given, const ImageSettings& settings) {
  if (!are_packed_) {
    overwrite(given.spheres, given_.size, given_.size);
    for (std::size_t k = 0; k < given_.size; ++k) {
      given.spheres[k] = kernels::sphere_at<Dim>(given_, k);
    }
  }
  lattice::check_range<Dim>(given.spheres, *lattice_, settings.margin, settings.shape);
}

/// Moves the elements in the fast way, but does nothing and returns false where rounding would make
/// the search use larger cells than the reach asks for, or images must be counted.
template <int Dim>
bool Images<Dim>::wrap_fast_if_near(const WrapEstimate<Dim>& wrap_estimate, const Plan& plan,
                                    const ImageSettings& settings) {
  const auto locals = static_cast<double>(given_.size);
  const double most =
      std::min(2.0 * ghosts_of_long_reach * locals, lattice::most_locals_and_ghosts - locals);
  const double ghosts = most_ghosts<Dim>(given_, plan.windows);
  if (!wrap_estimate.is_short || !(ghosts <= most)) return false;
  const lattice::CellExtent<Dim> as_given = extent_;
  extent_ = wrap_estimate.extent;
  slack_ = slack_of_fast_wraps * magnitude_of(plan.windows.of_large, plan.along, settings.shape);
  if (!is_covered_by_cells(slack_, settings.margin)) {
    extent_ = as_given;
    return false;
  }
  cells_moved_at_most_ = wrap_estimate.most_cells;
  cells_moved_.make_room(
      given_.size, std::all_of(wrap_estimate.most_cells.begin(), wrap_estimate.most_cells.end(),
                               [](double n) { return n <= MovedCells::most_packed; }));
  add_ghosts({own_spheres_, given_.size}, plan, settings);
  return true;
}

template <int Dim>
void Images<Dim>::wrap_exactly(const lattice::OrthogonalCell<Dim>& orthogonal_cell,
                               const Along& along, double start, std::size_t workers) {
  lattice::WrapSettings wrap_settings;
  wrap_settings.result_unit = unit_;
  wrap_settings.start = start;
  const lattice::Wrapper<Dim> wrapper(*lattice_, orthogonal_cell, along, wrap_settings);
  cells_moved_.make_room(given_.size, false);
  const lattice::OrthogonalCell<Dim> scaled_orthogonal_cell(*lattice_, unit_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, given_.size);
    FoundGhosts& part = parts_[worker];
    part.farthest = {};
    part.bounds = {};
    for (std::size_t i = first; i < last; ++i) {
      exact::Sphere<Dim> sphere = kernels::sphere_at<Dim>(given_, i);
      const lattice::CellsMoved moved = wrapper.wrap(sphere, i);
      cells_moved_.triples()[i] = moved;
      for (std::size_t k = 0; k < 3; ++k) {
        part.farthest[k] = std::max(part.farthest[k], std::abs(moved[k]));
      }
      own_spheres_[i] = sphere;
      part.bounds.include_center(sphere);
      part.bounds.include_radius(sphere.radius);
    }
    const std::span<const exact::Sphere<Dim>> locals = own_spheres_;
    part.extent = lattice::extent_of(locals.subspan(first, last - first), scaled_orthogonal_cell);
  });
  extent_ = {};
  bounds_ = {};
  for (std::size_t worker = 0; worker < workers; ++worker) {
    const FoundGhosts& part = parts_[worker];
    extent_.include(part.extent);
    bounds_.include(part.bounds);
    for (std::size_t k = 0; k < Dim; ++k) {
      cells_moved_at_most_[k] =
          std::max(cells_moved_at_most_[k], static_cast<double>(part.farthest[k]));
    }
  }
}

/// Adds the ghosts of the locals, which are what they shall be, or will be when they have been
/// moved.
template <int Dim>
void Images<Dim>::add_ghosts(const GhostArray& array, const Plan& plan,
                             const ImageSettings& settings) {
  require_narrow_windows<Dim>(plan.cell.count, plan.windows);
  note_shifts(plan.cell, plan.windows.of_large);
  if (!are_packed_ && !shifts_always_fit_) return;
  if (!plan.moves) {
    reach_is_long_ = is_long_reach<Dim>(locals_, plan.windows);
    if (array.locals > 0) locals_and_ghosts_ = array.spheres;
    if (reach_is_long_) return;
    require_countable<Dim>(locals_, plan.windows);
  }
  auto map = map_of<Dim>(*lattice_, plan.cell, plan.along, plan.windows);
  map.pack = cells_moved_.is_packed();
  const std::size_t workers = settings.workers;
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, locals_.size);
    FoundGhosts& part = parts_[worker];
    base::ProgressReporter* const progress = worker == 0 ? settings.progress : nullptr;
    part.bounds = {};
    part.ghosts.clear();
    for (std::size_t begin = first; begin < last; begin += kernels::BlockList::room) {
      const std::size_t count = std::min(last - begin, kernels::BlockList::room);
      kernels::BlockList outer;
      if (plan.moves) {
        wrap_fast<Dim>({given_, begin, count}, map, settings.kernels, array.spheres, cells_moved_,
                       part.bounds, outer);
      } else {
        list_outer<Dim>({locals_, begin, count}, map, settings.kernels, outer);
      }
      list_ghosts<Dim>({locals_, begin, count}, outer, plan.windows, part.ghosts, progress);
      if (progress != nullptr && (begin - first) % locals_between_polls == 0) progress->poll();
    }
  });
  if (plan.moves) join_boxes(workers);
  join_ghosts(workers);
  place_ghosts_at(array, settings);
}

/// The radii stay what they are.
template <int Dim>
void Images<Dim>::join_boxes(std::size_t workers) {
  grid::Bounds<Dim> box;
  for (std::size_t worker = 0; worker < workers; ++worker) box.include(parts_[worker].bounds);
  bounds_.lower = box.lower;
  bounds_.upper = box.upper;
}

template <int Dim>
void Images<Dim>::join_ghosts(std::size_t workers) {
  if (workers == 1) {
    ghosts_ = parts_[0].ghosts;
    return;
  }
  std::size_t count = 0;
  for (std::size_t worker = 0; worker < workers; ++worker) count += parts_[worker].ghosts.size();
  base::make_room(own_ghosts_, count);
  auto end = own_ghosts_.begin();
  for (std::size_t worker = 0; worker < workers; ++worker) {
    end = std::copy(parts_[worker].ghosts.begin(), parts_[worker].ghosts.end(), end);
  }
  ghosts_ = {own_ghosts_.data(), count};
}

template <int Dim>
void Images<Dim>::place_ghosts_at(const GhostArray& array, const ImageSettings& settings) {
  const std::size_t workers = settings.workers;
  const std::size_t all = array.locals + ghosts_.size();
  if (array.spheres.capacity() < all) array.spheres.reserve(all + ghosts_.size() / 4);
  array.spheres.resize(all);
  const std::span spheres(array.spheres);
  if (array.locals > 0) {
    locals_and_ghosts_ = spheres;
    locals_ = kernels::strided_spheres(locals_and_ghosts_.first(array.locals));
  }
  const auto ghost_spheres = spheres.subspan(array.locals);
  ghost_spheres_ = ghost_spheres;
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, ghosts_.size());
    parts_[worker].places = place_ghosts<Dim>(ghosts_.subspan(first, last - first), locals_, steps_,
                                              bounds_, ghost_spheres.subspan(first, last - first),
                                              worker == 0 ? settings.progress : nullptr);
  });
  for (std::size_t worker = 0; worker < workers; ++worker) places_.include(parts_[worker].places);
}

template <int Dim>
double Images<Dim>::magnitude_of(const Window& window, const Along& along, Shape shape) const {
  const double width = shape == Shape::box ? 2.0 * bounds_.largest_radius : 0.0;
  return lattice::magnitude_of<Dim>(extent_, window, along, steps_, width);
}

template class Images<2>;
template class Images<3>;

}  // namespace abut::periodic
