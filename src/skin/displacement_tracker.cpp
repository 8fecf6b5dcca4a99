#include "skin/displacement_tracker.hpp"

#include "base/asking_workers.hpp"
#include "elements/element_ids.hpp"
#include "elements/lattice_of.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::skin {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Relative error of a placed element, to the magnitude of the numbers it is computed from: 8 u.
constexpr double placing_error = 0x1p-50;

/// Cost of placing an element, in steps through an array.
constexpr std::uint64_t steps_of_placing = 4;

bool is_moved(const lattice::CellNumbers& cells) {
  return (cells[0] | cells[1] | cells[2]) != 0;
}

/// x - cells A. Raises `largest` to the sum of the amounts of all numbers that this takes.
template <int Dim>
exact::Sphere<Dim> place(const exact::Sphere<Dim>& sphere, const lattice::CellNumbers& cells,
                         const exact::Lattice& lattice, double& largest) {
  if (!is_moved(cells)) return sphere;
  double magnitude = 0.0;
  exact::Sphere<Dim> placed = sphere;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    magnitude += std::fabs(sphere.center[axis]);
    for (std::size_t k = 0; k < Dim; ++k) {
      if (cells[k] == 0) continue;
      const double product = cells[k] * lattice.vectors[k][axis];
      placed.center[axis] -= product;
      magnitude += std::fabs(product);
    }
  }
  largest = std::max(largest, magnitude);
  return placed;
}

/// False where numbers would become too large.
bool add(const lattice::CellNumbers& more, lattice::CellNumbers& cells) {
  constexpr std::int32_t most = 1 << 29;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k] += more[k];
    if (cells[k] > most || cells[k] < -most) return false;
  }
  return true;
}

/// Returns the magnitude of the coordinates of elements that no lattice vector moves.
template <int Dim>
double magnitude_of(const grid::Bounds<Dim>& bounds) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    sum += std::max(std::fabs(bounds.lower[axis]), std::fabs(bounds.upper[axis]));
  }
  return sum;
}

}  // namespace

template <int Dim>
void DisplacementTracker<Dim>::Part::include(const Part& others) noexcept {
  ways.include(others.ways);
  growth = std::max(growth, others.growth);
  magnitude = std::max(magnitude, others.magnitude);
  radii += others.radii;
  moved = moved || others.moved;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    lower[axis] = std::min(lower[axis], others.lower[axis]);
    upper[axis] = std::max(upper[axis], others.upper[axis]);
  }
}

template <int Dim>
DisplacementTracker<Dim>::DisplacementTracker(base::MemoryMeter& memory)
    : anchor_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      next_anchor_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      own_placed_(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
      cells_(base::make_array_for_overwrite<lattice::CellNumbers>(memory, 0)),
      next_cells_(base::make_array_for_overwrite<lattice::CellNumbers>(memory, 0)),
      moved_(base::make_array_for_overwrite<std::uint8_t>(memory, 0)) {}

template <int Dim>
bool DisplacementTracker<Dim>::start(const ElementsNow<Dim>& now) {
  stop();
  size_ = now.spheres.size();
  domain_then_ = domain_now_ = now.domain;
  anchor_bounds_ = now.bounds;
  base::make_room(anchor_, size_);
  if (now.domain.is_periodic()) {
    then_ = Frame(elements::lattice_of(now.domain));
    now_ = then_;
    if (!then_->accurate() || !then_->close_by(now.bounds, now.largest_reach())) return false;
    start_in_cell(now);
  } else {
    placed_ = now.spheres;
    double radii = 0.0;
    for (std::size_t i = 0; i < size_; ++i) {
      now.work.did(1);
      anchor_[i] = now.spheres[i];
      radii += now.spheres[i].radius;
    }
    mean_radius_ = size_ > 0 ? radii / static_cast<double>(size_) : 0.0;
  }
  started_ = true;
  return true;
}

/// Places each element in the cell around the middle of all: where the caller keeps elements in a
/// cell, they stay where they are.
template <int Dim>
void DisplacementTracker<Dim>::start_in_cell(const ElementsNow<Dim>& now) {
  base::make_room(own_placed_, size_);
  base::make_room(cells_, size_);
  base::make_room(moved_, size_);
  placed_ = {own_placed_.data(), size_};
  std::array<double, Dim> middle{};
  for (std::size_t k = 0; k < Dim; ++k) {
    middle[k] = 0.5 * now.bounds.lower[k] + 0.5 * now.bounds.upper[k];
  }
  for (std::size_t k = 0; k < Dim; ++k) middle_[k] = then_->fraction(k, middle.data());

  parts_.assign(now.workers, {});
  base::for_each_share(now.workers, now.work, [&](std::size_t worker, base::WorkCounter& work) {
    Part part;
    part.lower.fill(infinite);
    part.upper.fill(-infinite);
    const auto [first, last] = base::share_of(worker, now.workers, size_);
    for (std::size_t i = first; i < last; ++i) {
      work.did(steps_of_placing);
      cells_[i] = cells_around_middle(*then_, now.spheres[i].center);
      anchor_[i] = own_placed_[i] =
          place(now.spheres[i], cells_[i], then_->lattice(), part.magnitude);
      moved_[i] = is_moved(cells_[i]) ? 1 : 0;
      part.moved = part.moved || moved(i);
      include_fractions(anchor_[i], part);
      part.radii += now.spheres[i].radius;
    }
    parts_[worker] = part;
  });
  anchored_ = parts_[0];
  for (std::size_t worker = 1; worker < now.workers; ++worker) anchored_.include(parts_[worker]);
  mean_radius_ = size_ > 0 ? anchored_.radii / static_cast<double>(size_) : 0.0;
  any_moved_ = anchored_.moved;
  magnitude_ = magnitude_then_ = std::max(anchored_.magnitude, magnitude_of(now.bounds));
  derive_spread();
}

template <int Dim>
lattice::CellNumbers DisplacementTracker<Dim>::cells_around_middle(const Frame& frame,
                                                                   const double* position) const {
  lattice::CellNumbers cells{};
  for (std::size_t k = 0; k < Dim; ++k) {
    cells[k] = static_cast<std::int32_t>(std::nearbyint(frame.fraction(k, position) - middle_[k]));
  }
  return cells;
}

template <int Dim>
void DisplacementTracker<Dim>::include_fractions(const exact::Sphere<Dim>& anchor,
                                                 Part& part) const {
  for (std::size_t k = 0; k < Dim; ++k) {
    const double fraction = then_->fraction(k, anchor.center);
    part.lower[k] = std::min(part.lower[k], fraction);
    part.upper[k] = std::max(part.upper[k], fraction);
  }
}

template <int Dim>
void DisplacementTracker<Dim>::derive_spread() {
  for (std::size_t k = 0; k < Dim; ++k) {
    // Fractions are off by a few roundings of what they are summed from.
    const double error = 0x1p-45 * then_->dual_length(k) * magnitude_then_;
    spread_[k] = size_ > 0 ? anchored_.upper[k] - anchored_.lower[k] + error : 0.0;
  }
}

/// Anchors may be anywhere, and so may the cell in which a new element is placed
/// (docs/derivations/skin.md).
template <int Dim>
void DisplacementTracker<Dim>::renumber(const ElementsNow<Dim>& now,
                                        std::span<const std::uint32_t> before) {
  const bool periodic = now.domain.is_periodic();
  if (!started_ || now.domain.periodic_axes() != domain_then_.periodic_axes()) return stop();
  if (periodic) {
    follow_lattice(now.domain);
    if (!now_->close_by(now.bounds, now.largest_reach())) return stop();
    magnitude_then_ = std::max(magnitude_then_, magnitude_of(now.bounds));
  }
  size_ = now.spheres.size();
  anchor_bounds_.include(now.bounds);
  base::make_room(next_anchor_, size_);
  if (periodic) base::make_room(next_cells_, size_);
  for (std::size_t i = 0; i < size_; ++i) {
    now.work.did(periodic ? steps_of_placing : 1);
    if (before[i] != elements::ElementIds::none) {
      next_anchor_[i] = anchor_[before[i]];
      if (periodic) next_cells_[i] = cells_[before[i]];
    } else if (!periodic) {
      next_anchor_[i] = now.spheres[i];
    } else {
      next_cells_[i] = cells_around_middle(*now_, now.spheres[i].center);
      next_anchor_[i] = place(now.spheres[i], next_cells_[i], now_->lattice(), magnitude_then_);
      include_fractions(next_anchor_[i], anchored_);
    }
  }
  anchor_.swap(next_anchor_);
  if (!periodic) return;
  cells_.swap(next_cells_);
  base::make_room(own_placed_, size_);
  base::make_room(moved_, size_);
  placed_ = {own_placed_.data(), size_};
  derive_spread();
}

template <int Dim>
void DisplacementTracker<Dim>::follow_lattice(const Domain& domain) {
  if (domain == domain_now_) return;
  now_ = Frame(elements::lattice_of(domain));
  domain_now_ = domain;
}

template <int Dim>
bool DisplacementTracker<Dim>::comparable(const ElementsNow<Dim>& now) const noexcept {
  return started_ && now.spheres.size() == size_ &&
         now.domain.periodic_axes() == domain_then_.periodic_axes();
}

template <int Dim>
double DisplacementTracker<Dim>::approach(const ElementsNow<Dim>& now, double allowed) {
  if (!comparable(now)) return infinite;
  const bool periodic = now.domain.is_periodic();
  if (periodic) follow_lattice(now.domain);
  if (periodic && !now_->close_by(now.bounds, now.largest_reach())) return infinite;
  if (!(allowed >= 0.0)) return infinite;
  const Part all = measure(now, allowed);
  any_moved_ = all.moved;
  double sum = all.ways.sum_of_two();
  if (!periodic || !all.ways.known()) return sum * (1.0 + kernels::displacement_band);
  magnitude_ = std::max(all.magnitude, magnitude_of(now.bounds));
  // Two elements, placed then and now; of an element and its own image only the radius counts.
  sum = std::max(sum, 2.0 * all.growth) + 2.0 * placing_error * (magnitude_then_ + magnitude_);
  sum *= 1.0 + kernels::displacement_band;
  if (!(sum <= allowed)) return sum;
  sum += lattice::image_motion(*then_, *now_, spread_, now.largest_reach() + sum);
  return sum * (1.0 + kernels::displacement_band);
}

template <int Dim>
typename DisplacementTracker<Dim>::Part DisplacementTracker<Dim>::measure(
    const ElementsNow<Dim>& now, double allowed) {
  const bool periodic = now.domain.is_periodic();
  if (!periodic) placed_ = now.spheres;
  parts_.assign(now.workers, {});
  base::for_each_share(now.workers, now.work, [&](std::size_t share, base::WorkCounter& work) {
    const auto [first, last] = base::share_of(share, now.workers, size_);
    work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      if (periodic) work.did(steps_of_placing * (end - begin));
      periodic ? measure_periodic(now, allowed, begin, end, parts_[share])
               : measure_open(now, begin, end, parts_[share]);
    });
  });
  Part all;
  for (const Part& part : parts_) all.include(part);
  return all;
}

template <int Dim>
void DisplacementTracker<Dim>::measure_open(const ElementsNow<Dim>& now, std::size_t first,
                                            std::size_t last, Part& part) const {
  const exact::Sphere<Dim>* const spheres = now.spheres.data();
  const exact::Sphere<Dim>* const anchors = anchor_.data();
  for (std::size_t i = first; i < last; ++i) {
    part.ways.include_square(squared_displacement(spheres[i], anchors[i]),
                             spheres[i].radius - anchors[i].radius);
  }
}

/// An element that seems to have moved far has perhaps been moved by lattice vectors.
template <int Dim>
void DisplacementTracker<Dim>::measure_periodic(const ElementsNow<Dim>& now, double allowed,
                                                std::size_t first, std::size_t last, Part& part) {
  const exact::Lattice& lattice = now_->lattice();
  const double far = allowed * allowed;
  for (std::size_t i = first; i < last; ++i) {
    exact::Sphere<Dim> placed = place(now.spheres[i], cells_[i], lattice, part.magnitude);
    double square = squared_displacement(placed, anchor_[i]);
    if (!(square <= far)) {
      std::array<double, Dim> difference{};
      for (std::size_t k = 0; k < Dim; ++k) {
        difference[k] = placed.center[k] - anchor_[i].center[k];
      }
      lattice::CellNumbers more{};
      if (!now_->nearest(difference.data(), more) || !add(more, cells_[i])) {
        part.ways.include_unknown();
      }
      placed = place(now.spheres[i], cells_[i], lattice, part.magnitude);
      square = squared_displacement(placed, anchor_[i]);
    }
    own_placed_[i] = placed;
    moved_[i] = is_moved(cells_[i]) ? 1 : 0;
    part.moved = part.moved || moved(i);
    const double growth = placed.radius - anchor_[i].radius;
    part.growth = std::max(part.growth, growth);
    part.ways.include_square(square, growth);
  }
}

template class DisplacementTracker<2>;
template class DisplacementTracker<3>;

}  // namespace abut::skin
