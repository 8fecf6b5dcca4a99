#include "grid/images.hpp"

#include "base/workers.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace abut::grid {
namespace {

/// Beyond this, sums could leave the exponent range; natives and ghosts are scaled down.
constexpr double largest_unscaled = 0x1p960;
constexpr double scale_down = 0x1p-128;

/// Natives and ghosts are numbered by 32 bits.
constexpr double most_images = 4294967294.0;

template <int Dim>
double largest_number(const Bounds<Dim>& bounds, const ReducedLattice<Dim>& lattice,
                      double margin) {
  double largest = std::max(bounds.largest_radius, margin);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis])});
  }
  for (std::size_t k = 0; k < lattice.count; ++k) largest = std::max(largest, lattice.length[k]);
  return largest;
}

/// Elements are moved along the vectors that they spread over more than a cell of. A little more,
/// a quarter of what ghosts are within, costs fewer ghosts than moving elements costs time. What
/// overflows is left to the wrapper, which knows the element.
template <int Dim>
std::array<bool, Dim> axes_to_wrap(const FractionMap<Dim>& fractions, const CellExtent<Dim>& extent,
                                   const GhostWindow<Dim>& window) {
  std::array<bool, Dim> along{};
  for (std::size_t k = 0; k < fractions.count; ++k) {
    const double spread = extent.upper[k] - extent.lower[k];
    const bool overflows = !std::isfinite(fractions.magnitude(k, extent.farthest));
    along[k] = overflows || !(spread <= 1.0 + 0.25 * std::min(window.widest(k), 1.0));
  }
  return along;
}

[[noreturn]] void refuse_number_of_images() {
  throw Error(ErrorCode::limit_exceeded,
              "more than 4294967294 periodic images are within reach of the cell; make the lattice "
              "vectors longer, or radii and margin smaller");
}

/// A bound from the widest box; where it is too large, the exact number.
template <int Dim>
void require_countable(std::span<const base::Sphere<Dim>> natives, std::size_t vectors,
                       const GhostWindow<Dim>& window) {
  double bound = static_cast<double>(natives.size());
  for (std::size_t k = 0; k < vectors; ++k) {
    if (!(window.most_cells(k) <= most_cells_away)) refuse_number_of_images();
    bound *= 2.0 * window.most_cells(k);
  }
  if (bound <= most_images) return;
  double count = static_cast<double>(natives.size());
  for (const base::Sphere<Dim>& native : natives) {
    count += positive_images(window.box_of(native));
    if (count > most_images) refuse_number_of_images();
  }
}

/// In blocks: those far inside are passed over without a branch.
template <int Dim>
void append_ghosts(std::span<const base::Sphere<Dim>> natives, std::size_t first, std::size_t last,
                   const GhostWindow<Dim>& window, base::Array<Ghost>& ghosts) {
  constexpr std::size_t block_size = 512;
  std::array<std::uint32_t, block_size> outer;
  for (std::size_t begin = first; begin < last; begin += block_size) {
    const auto block = natives.subspan(begin, std::min(block_size, last - begin));
    const std::size_t count = window.outer_of(block, outer.data());
    for (std::size_t k = 0; k < count; ++k) {
      const auto number = static_cast<std::uint32_t>(begin + outer[k]);
      for_each_positive_image(window.box_of(natives[number]), [&](const ImageNumbers& image) {
        ghosts.push_back({number,
                          {static_cast<std::int32_t>(image[0]), static_cast<std::int32_t>(image[1]),
                           static_cast<std::int32_t>(image[2])}});
      });
    }
  }
}

}  // namespace

template <int Dim>
Images<Dim>::Images(base::MemoryMeter& memory)
    : memory_(memory),
      own_natives_(base::make_array_for_overwrite<base::Sphere<Dim>>(memory, 0)),
      cells_moved_(base::make_array_for_overwrite<CellsMoved>(memory, 0)),
      own_ghosts_(base::make_array_for_overwrite<Ghost>(memory, 0)) {}

template <int Dim>
void Images<Dim>::find(std::span<const base::Sphere<Dim>> spheres, const Bounds<Dim>& bounds,
                       const ReducedLattice<Dim>& lattice, double margin, std::size_t workers) {
  lattice_ = &lattice;
  natives_ = spheres;
  ghosts_ = {};
  unit_ = 1.0;
  slack_ = 0.0;
  moved_any_ = false;
  bounds_ = bounds;
  if (spheres.empty() || lattice.count == 0) return;

  while (parts_.size() < workers) parts_.emplace_back(memory_);
  place_natives(spheres, bounds, margin, workers);
  const Reaches reaches{bounds.largest_radius * unit_, margin * unit_};
  const GhostWindow<Dim> window(lattice, extent_, reaches, unit_);
  require_countable(natives_, lattice.count, window);
  find_ghosts(window, workers);

  slack_ = slack_of(window);
  shifts_always_fit_ = all_shifts_fit(window, workers);
}

/// By an upper bound; the roundings of doubles are far below the half that is left.
template <int Dim>
bool Images<Dim>::all_shifts_fit(const GhostWindow<Dim>& window, std::size_t workers) const {
  std::array<double, 3> shift{};
  for (std::size_t k = 0; k < lattice_->count; ++k) {
    double number = window.most_cells(k);
    double moved = 0.0;
    for (std::size_t worker = 0; moved_any_ && worker < workers; ++worker) {
      moved = std::max(moved, static_cast<double>(parts_[worker].farthest[k]));
    }
    number += 2.0 * moved;
    for (std::size_t l = 0; l < lattice_->count; ++l) {
      shift[l] += number * std::fabs(static_cast<double>(lattice_->to_given[k][l]));
    }
  }
  return std::all_of(shift.begin(), shift.end(), [](double n) { return n < 0x1p30; });
}

/// Where no basis vector leads along an axis, nothing is added to coordinates on it.
template <int Dim>
double Images<Dim>::slack_of(const GhostWindow<Dim>& window) const {
  double magnitude = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    double moved = 0.0;
    for (std::size_t k = 0; k < lattice_->count; ++k) {
      moved += window.most_cells(k) * std::fabs(steps_[k][axis]);
    }
    if (moved > 0.0) magnitude += extent_.farthest[axis] + moved;
  }
  return 0x1p-48 * magnitude;
}

template <int Dim>
void Images<Dim>::place_natives(std::span<const base::Sphere<Dim>> spheres,
                                const Bounds<Dim>& bounds, double margin, std::size_t workers) {
  const FractionMap<Dim> fractions(*lattice_, 1.0);
  if (fractions.is_aligned()) {
    extent_ = extent_of(bounds, fractions);
  } else {
    base::for_each_worker(workers, [&](std::size_t worker) {
      const auto [first, last] = base::share_of(worker, workers, spheres.size());
      parts_[worker].extent = extent_of(spheres.subspan(first, last - first), fractions);
    });
    join_extents(workers);
  }
  if (largest_number(bounds, *lattice_, margin) > largest_unscaled) unit_ = scale_down;
  for (std::size_t k = 0; k < Dim; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      steps_[k][axis] = lattice_->vectors[k][axis] * unit_;
    }
  }
  const GhostWindow<Dim> window(*lattice_, extent_, {bounds.largest_radius, margin}, 1.0);
  const auto along = axes_to_wrap(fractions, extent_, window);
  moved_any_ = std::count(along.begin(), along.end(), true) > 0;
  if (moved_any_ || unit_ != 1.0) move_natives(spheres, along, workers);
}

template <int Dim>
void Images<Dim>::join_extents(std::size_t workers) {
  extent_ = {};
  for (std::size_t worker = 0; worker < workers; ++worker) extent_.include(parts_[worker].extent);
}

template <int Dim>
void Images<Dim>::move_natives(std::span<const base::Sphere<Dim>> spheres,
                               const std::array<bool, Dim>& along, std::size_t workers) {
  base::make_room(own_natives_, spheres.size());
  base::make_room(cells_moved_, spheres.size());
  natives_ = {own_natives_.data(), spheres.size()};
  const Wrapper<Dim> wrapper(*lattice_, along);
  const FractionMap<Dim> fractions(*lattice_, unit_);
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, spheres.size());
    Bounds<Dim> bounds;
    CellsMoved farthest{};
    for (std::size_t i = first; i < last; ++i) {
      base::Sphere<Dim> sphere = spheres[i];
      cells_moved_[i] = wrapper.wrap(sphere, i);
      for (std::size_t k = 0; k < 3; ++k) {
        farthest[k] = std::max(farthest[k], std::abs(cells_moved_[i][k]));
      }
      for (double& x : sphere.center) x *= unit_;
      sphere.radius *= unit_;
      own_natives_[i] = sphere;
      bounds.include_center(sphere);
      bounds.include_radius(sphere.radius);
    }
    parts_[worker].bounds = bounds;
    parts_[worker].farthest = farthest;
    parts_[worker].extent = extent_of(natives_.subspan(first, last - first), fractions);
  });
  join_extents(workers);
  bounds_ = {};
  for (std::size_t worker = 0; worker < workers; ++worker) bounds_.include(parts_[worker].bounds);
}

template <int Dim>
void Images<Dim>::find_ghosts(const GhostWindow<Dim>& window, std::size_t workers) {
  base::for_each_worker(workers, [&](std::size_t worker) {
    const auto [first, last] = base::share_of(worker, workers, natives_.size());
    parts_[worker].ghosts.clear();
    append_ghosts(natives_, first, last, window, parts_[worker].ghosts);
  });
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
base::ImageShift Images<Dim>::shift_between(std::size_t i, std::size_t j,
                                            const std::array<std::int32_t, 3>& image) const {
  ImageNumbers numbers{};
  for (std::size_t k = 0; k < 3; ++k) {
    numbers[k] = image[k];
    if (moved_any_) numbers[k] += std::int64_t{cells_moved_[i][k]} - cells_moved_[j][k];
  }
  if (const auto shift = lattice_->shift_of(numbers)) return *shift;
  throw Error(ErrorCode::invalid_input,
              "elements " + std::to_string(i) + " and " + std::to_string(j) +
                  " pair across more than 2147483647 lattice vectors; move them into one cell");
}

template class Images<2>;
template class Images<3>;

}  // namespace abut::grid
