#include "engine/plane/plane_grid.hpp"

#include "base/scattered.hpp"
#include "engine/box_in_cells.hpp"
#include "engine/set_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut::engine {
namespace {

/// The most columns of a row, for which the proof has room (docs/derivations/plane.md).
constexpr double most_columns = 8191.0;

/// Columns are an element wide if all are spread equally, but no narrower than an eighth of the
/// reach: an element looks a column farther than it reaches.
constexpr double columns_in_reach = 8.0;

/// Elements for each row, at least: rows have tables.
constexpr double least_in_row = 8.0;

/// An element in several rows meets so many times what it would meet in one of them: those ahead of
/// it in its own, and those on both sides of it in the next.
constexpr double sides_in_rows = 3.0;

/// One row is kept where several would save less, in candidates of an element: it looks into two of
/// them then. With many hits, all runs of a row take equally many vectors, and it is less.
constexpr double least_saved_with_few_hits = 30.0;
constexpr double least_saved_with_many_hits = 6.0;

/// Elements that are looked at, spread over all, where clusters may be; and candidates that an
/// element would have by these, from which on there are some; or more than a plane suits, where
/// that is fewer.
constexpr std::size_t looked_at = 32;
constexpr double least_met_in_clusters = 30.0;

/// The reach, in units, from which on few pairs are left undecided.
constexpr double least_well_known = 0x1p-12;

/// How much farther apart, in units, than the filter must know positions are taken to be, and how
/// much farther in columns and rows, of which there are fewer than 2^14
/// (docs/derivations/plane.md).
constexpr double error_of_distance = 4.0 * kernels::filter_error;
constexpr double error_of_place = 0x1p-7;

/// Rows are so many times as wide as the reach.
constexpr double row_margin = 1.0 + 0x1p-6;

template <int Dim>
kernels::ElementShape shape_of(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  if (input.spheres.stand_for_boxes()) return kernels::ElementShape::boxes;
  return set.bounds.smallest_radius == set.bounds.largest_radius
             ? kernels::ElementShape::equal_spheres
             : kernels::ElementShape::spheres;
}

/// A power of two that makes a length at most 1.
double unit_of(double length) {
  return std::ldexp(1.0, -(std::ilogb(length) + 1));
}

}  // namespace

template <int Dim>
PlaneGrid<Dim>::PlaneGrid(const SearchSet<Dim>& set, const SearchInput<Dim>& input)
    : shape_(shape_of(set, input)) {
  const grid::Bounds<Dim>& bounds = set.bounds;
  order_axes(bounds);
  const double unit = unit_of(std::max(extent_[0], cell_size_for(bounds, input)));
  std::copy(bounds.lower.begin(), bounds.lower.end(), map_.lower);
  map_.unit = unit;
  for (double& extent : extent_) extent *= unit;
  largest_radius_ = length(bounds.largest_radius);
  const double largest = (bounds.largest_radius + input.margin) * unit + error_of_distance;
  reach_ = largest + bounds.second_largest_radius * unit;
  least_reach_ = largest + bounds.smallest_radius * unit;
  has_few_hits_ = hits(set, input.margin) < kernels::few_hits_in_plane;
  const double cells = input.layer_limits.least_cells_of_clusters;
  is_nearly_empty_ = BoxInCells<Dim>(bounds, cell_size_for(bounds, input)).cells >=
                     cells * static_cast<double>(set.locals.size());
  divide_into_rows(set.locals.size());
  divide_into_columns(set.locals.size());
  look_ahead(largest);
}

template <int Dim>
void PlaneGrid<Dim>::order_axes(const grid::Bounds<Dim>& bounds) noexcept {
  const auto extent = [&](std::size_t axis) { return bounds.upper[axis] - bounds.lower[axis]; };
  std::iota(axes_.begin(), axes_.end(), std::size_t{0});
  std::sort(axes_.begin(), axes_.end(), [&](std::size_t a, std::size_t b) {
    return extent(a) > extent(b) || (extent(a) == extent(b) && a < b);
  });
  for (std::size_t k = 0; k < Dim; ++k) extent_[k] = extent(axes_[k]);
}

template <int Dim>
void PlaneGrid<Dim>::divide_into_rows(std::size_t elements) noexcept {
  const double most =
      std::min({std::floor(extent_[1] / (reach_ * row_margin)),
                std::floor(static_cast<double>(elements) / least_in_row), most_columns});
  const double least = has_few_hits_ ? least_saved_with_few_hits : least_saved_with_many_hits;
  if (!(met_in_one_row(elements) * (1.0 - sides_in_rows / most) > least)) return;
  rows_ = static_cast<std::uint32_t>(most);
  map_.per_unit[1] = static_cast<float>(rows_ / extent_[1]);
  map_.last[1] = static_cast<float>(rows_ - 1);
}

template <int Dim>
void PlaneGrid<Dim>::divide_into_columns(std::size_t elements) noexcept {
  const double most =
      std::min(static_cast<double>(elements) / rows_, columns_in_reach * extent_[0] / reach_);
  if (!(most >= 2.0)) return;
  columns_ = static_cast<std::uint32_t>(most);
  map_.per_unit[0] = static_cast<float>(columns_ / extent_[0]);
  map_.last[0] = static_cast<float>(columns_ - 1);
}

/// Says how far spheres look whose reach, with one as large as the largest, is their radius and so
/// much.
template <int Dim>
void PlaneGrid<Dim>::look_ahead(double largest) noexcept {
  const double per_unit = map_.per_unit[0];
  if (columns_ > 1) {
    looked_ahead_ = {static_cast<float>(largest + error_of_place / per_unit), map_.per_unit[0],
                     static_cast<std::uint32_t>(reach_ * per_unit + error_of_place) + 1};
  }
  map_.first_column = looked_ahead_.widest;
  map_.row_length = 2 * looked_ahead_.widest + columns_ + 1;
}

/// Pairs of an element of the smallest size, if all are spread equally: half of those within reach
/// of it, in a circle or a sphere, or twice as many of boxes.
template <int Dim>
double PlaneGrid<Dim>::hits(const SearchSet<Dim>& set, double margin) const noexcept {
  constexpr double half_unit_ball = Dim == 2 ? 1.571 : 2.094;
  const double reach = (2.0 * set.bounds.smallest_radius + margin) * map_.unit;
  double result = half_unit_ball * static_cast<double>(set.locals.size());
  for (const double extent : extent_) result *= reach / (extent + reach);
  return shape_ == kernels::ElementShape::boxes ? 2.0 * result : result;
}

/// The elements ahead of one of the smallest within reach on the first axis, if all are spread
/// equally.
template <int Dim>
double PlaneGrid<Dim>::met_in_one_row(std::size_t elements) const noexcept {
  const double part = std::min(1.0, least_reach_ / extent_[0]);
  return static_cast<double>(elements) * part * (1.0 - 0.5 * part);
}

template <int Dim>
bool PlaneGrid<Dim>::has_clusters(const LayerSpheres<Dim>& elements,
                                  const PlaneLimits& limits) const noexcept {
  if (!is_nearly_empty_) return false;
  std::array<std::uint32_t, looked_at> drawn{};
  std::array<std::uint32_t, looked_at> columns{};
  for (std::size_t k = 0; k < looked_at; ++k) {
    drawn[k] = static_cast<std::uint32_t>(base::one_of(elements.size(), k));
    const exact::Sphere<Dim> sphere = elements[drawn[k]];
    columns[k] = column(position(sphere.center, axes_[0]), position(sphere.center, axes_[1]));
  }
  const std::uint32_t ahead = looked_ahead_.widest;
  std::uint32_t near = 0;
  for (std::size_t k = 0; k < looked_at; ++k) {
    for (std::size_t other = 0; other < looked_at; ++other) {
      near +=
          (columns[other] - columns[k] <= ahead ? 1u : 0u) & (drawn[other] != drawn[k] ? 1u : 0u);
    }
  }
  constexpr double pairs_looked_at = looked_at * looked_at;
  const double met = static_cast<double>(near) * static_cast<double>(elements.size());
  return met > std::min(least_met_in_clusters, most_met(limits)) * pairs_looked_at;
}

template <int Dim>
bool PlaneGrid<Dim>::suits_crowds_of(std::size_t elements,
                                     const PlaneLimits& limits) const noexcept {
  const bool are_far_apart = reach_ - error_of_distance < limits.least_reach_of_crowds;
  return elements <= (are_far_apart ? limits.always_far_apart : limits.always);
}

template <int Dim>
double PlaneGrid<Dim>::most_met(const PlaneLimits& limits) const noexcept {
  const double most = limits.most_met;
  const double well_known = (reach_ - error_of_distance) / least_well_known;
  return well_known < 1.0 ? std::clamp(most * well_known, limits.most_met_far_apart, most) : most;
}

template <int Dim>
std::optional<PlaneGrid<Dim>> PlaneGrid<Dim>::over(const SearchSet<Dim>& set,
                                                   const SearchInput<Dim>& input) {
  const std::size_t elements = set.locals.size();
  const PlaneGrid grid(set, input);
  const PlaneLimits& limits = input.layer_limits.plane;
  if (Dim == 2 && !grid.has_few_hits_ && elements > limits.most_with_many_hits_in_2d) {
    return std::nullopt;
  }
  if (grid.suits_crowds_of(elements, limits)) return grid;
  const double sides = grid.rows_ == 1 ? 1.0 : sides_in_rows / grid.rows_;
  if (!(sides * grid.met_in_one_row(elements) <= grid.most_met(limits))) return std::nullopt;
  return grid;
}

template class PlaneGrid<2>;
template class PlaneGrid<3>;

}  // namespace abut::engine
