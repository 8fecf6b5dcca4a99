#include "engine/layers/layer_grid.hpp"

#include "engine/box_in_cells.hpp"
#include "engine/layers/largest_square.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace abut::engine {
namespace {

/// Columns are cells / 2^k: so narrow that two runs seldom have more elements than a vector has
/// lanes, so wide that their table is not longer than the elements' own columns.
constexpr int most_halvings = 2;
/// Cells that are wider than the reach by more than this have half as many columns.
constexpr double wide_cell = 1.5;

/// Radii and margins beyond have squares that single precision does not hold.
constexpr float most_units = 0x1p60f;

/// Elements of a strip in 2D, at most, which is sorted within the nearest caches; the same of up to
/// four long rows, for a table has two rows besides; and strips, at least, that workers may share
/// out.
constexpr double most_elements_of_strip = 4096.0;
constexpr double most_elements_of_four_rows = 32768.0;
constexpr double least_strips = 24.0;

/// Cells of the size that the reach needs, for each element, up to which they are not widened: that
/// many empty ones cost less than elements that share cells.
constexpr double most_cells_of_element = 3.0;

/// The same where elements crowd in a part of them.
constexpr double most_narrow_cells_of_element = 16.0;

/// Returns the size of cells: `least`, or where most would be empty, such that the box has about as
/// many as elements.
template <int Dim>
double cell_size(const grid::Bounds<Dim>& bounds, double least, double elements) {
  const bool has_few = BoxInCells<Dim>(bounds, least).cells <= most_cells_of_element * elements;
  return has_few ? least : cell_for(bounds, least, elements);
}

/// Bits of an exact position below its cell: squares of distances between adjacent cells, and their
/// sums, have less than 31.
constexpr int bits_of_exact_cell = 13;
/// Twice the slack, and more than what rounds the bounds of the gap of two boxes.
constexpr float band_of_boxes = 4.0f * kernels::layer_slack;

/// Units of a step, at least: with n of them cells are wider than needed by 1 / n at most; and at
/// most, which no axis is longer than.
constexpr double fewest_units_of_step = 8.0;
constexpr double most_units_of_step = 0x1p24;

/// A position has 31 bits: with one for its cell, an axis has two of these.
constexpr int most_bits_of_cell = 30;

/// Returns the finest units in which positions fit, if there are any: the finer, the fewer pairs
/// are left undecided. A cell has up to 2^22 of them, or more by the power of two by which it is
/// wider than needed, and on the longest axes as few as 2^16.
template <int Dim>
LayerUnits units_for(const grid::Bounds<Dim>& bounds, double cell, double least) {
  double longest = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    longest = std::max(longest, bounds.upper[axis] - bounds.lower[axis]);
  }
  int wider = 0;
  for (double half = 0.5 * cell; half >= least && wider < most_bits_of_cell; half *= 0.5) ++wider;
  int shift = std::min(kernels::most_cell_bits + wider, most_bits_of_cell);
  int reach_bits = 0;
  for (; shift >= kernels::least_cell_bits; --shift) {
    reach_bits = std::min(std::max(shift - wider, kernels::cell_bits), shift);
    const double end = kernels::end_of_positions(reach_bits);
    if (longest * (std::ldexp(1.0, shift) / cell) < end) break;
  }
  return {std::max(shift, kernels::least_cell_bits), reach_bits};
}

/// The axes, the shortest first; of equal ones the first.
template <int Dim>
std::array<std::size_t, Dim> axes_by_extent(const grid::Bounds<Dim>& bounds) {
  std::array<std::size_t, Dim> axes{};
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  const auto extent = [&](std::size_t axis) { return bounds.upper[axis] - bounds.lower[axis]; };
  std::sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return extent(a) != extent(b) ? extent(a) < extent(b) : a < b;
  });
  return axes;
}

}  // namespace

template <int Dim>
std::optional<LayerGrid<Dim>> LayerGrid<Dim>::over(const grid::Bounds<Dim>& bounds, double margin,
                                                   double least_cell, std::size_t elements) {
  const double cell = cell_size(bounds, least_cell, static_cast<double>(elements));
  return of_reach(bounds, margin, least_cell, cell, elements);
}

template <int Dim>
std::optional<LayerGrid<Dim>> LayerGrid<Dim>::narrow(const grid::Bounds<Dim>& bounds, double margin,
                                                     double least_cell, std::size_t elements) {
  const double cells = most_narrow_cells_of_element * static_cast<double>(elements);
  return of_reach(bounds, margin, least_cell, cell_for(bounds, least_cell, cells), elements);
}

template <int Dim>
std::optional<LayerGrid<Dim>> LayerGrid<Dim>::of_reach(const grid::Bounds<Dim>& bounds,
                                                       double margin, double least_cell,
                                                       double cell, std::size_t elements) {
  LayerGrid grid;
  const LayerUnits units = units_for(bounds, cell, least_cell);
  if (!grid.lay_out(bounds, std::ldexp(1.0, units.cell_shift) / cell, units)) return std::nullopt;
  grid.has_wide_cells_ = cell > least_cell;
  grid.cut_rows(bounds, margin, 2.0 * double{kernels::layer_slack});
  if constexpr (Dim == 2) grid.join_rows(elements);
  return grid;
}

template <int Dim>
double LayerGrid<Dim>::least_step_of(double cell) noexcept {
  return std::ldexp(fewest_units_of_step * cell, -bits_of_exact_cell);
}

template <int Dim>
std::optional<LayerGrid<Dim>> LayerGrid<Dim>::in_steps(const grid::Bounds<Dim>& bounds,
                                                       double margin, std::size_t elements,
                                                       double step) const {
  const double fitting = std::floor(std::ldexp(step / cell(), bits_of_exact_cell));
  const double units = std::min(fitting, most_units_of_step);
  LayerGrid grid;
  if (!(units >= fewest_units_of_step) ||
      !grid.lay_out(bounds, units / step, {bits_of_exact_cell, kernels::least_cell_bits})) {
    return std::nullopt;
  }
  grid.has_wide_cells_ = has_wide_cells_;
  grid.cut_rows(bounds, margin, 0.0);
  grid.largest_square_ = largest_square_within(2.0 * bounds.largest_radius, margin, step, units);
  if constexpr (Dim == 2) grid.join_rows(elements);
  return grid;
}

template <int Dim>
std::optional<LayerGrid<Dim>> LayerGrid<Dim>::of_cells(const grid::Bounds<Dim>& bounds,
                                                       double margin, double cell,
                                                       std::size_t elements) {
  LayerGrid grid;
  const double units_of_one = std::ldexp(1.0, kernels::cell_bits) / cell;
  if (!grid.lay_out(bounds, units_of_one, {kernels::cell_bits, kernels::cell_bits})) {
    return std::nullopt;
  }
  grid.cut_rows_by_size(margin);
  if (!(grid.units_of(bounds.largest_radius) < most_units) || !(grid.margin_ < most_units)) {
    return std::nullopt;
  }
  if constexpr (Dim == 2) grid.join_rows(elements);
  return grid;
}

template <int Dim>
bool LayerGrid<Dim>::lay_out(const grid::Bounds<Dim>& bounds, double units_of_one,
                             const LayerUnits& units) {
  cell_shift_ = units.cell_shift;
  reach_bits_ = units.reach_bits;
  map_.units_of_one = units_of_one;
  // Exact positions have fewer units to a cell, but no more cells.
  const double end = std::ldexp(kernels::end_of_positions(reach_bits_),
                                std::min(cell_shift_ - kernels::least_cell_bits, 0));
  std::array<std::uint32_t, Dim> cells{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    map_.lower[axis] = bounds.lower[axis];
    const double last = (bounds.upper[axis] - bounds.lower[axis]) * map_.units_of_one;
    if (!(last < end)) return false;
    cells[axis] = (static_cast<std::uint32_t>(last) >> cell_shift_) + 1;
  }
  const std::array<std::size_t, Dim> axes = axes_by_extent(bounds);
  const std::size_t layer_axis = axes[Dim - 1];
  map_.layer_axis = static_cast<int>(layer_axis);
  map_.layer_shift = cell_shift_;
  row_axis_ = axes[Dim - 2];
  next_row_axis_ = Dim == 2 ? layer_axis : axes[0];
  layers_ = cells[layer_axis];
  rows_ = cells[next_row_axis_];
  columns_ = cells[row_axis_];
  return true;
}

template <int Dim>
void LayerGrid<Dim>::cut_rows(const grid::Bounds<Dim>& bounds, double margin, double slack) {
  const double reach = bounds.largest_radius + bounds.second_largest_radius + margin;
  const double cell = std::ldexp(1.0, cell_shift_);
  const bool is_wide = cell > wide_cell * (reach * map_.units_of_one);
  const int halvings = is_wide ? most_halvings - 1 : most_halvings;
  column_shift_ = cell_shift_ - halvings;
  columns_ <<= halvings;
  const double units = reach * map_.units_of_one;
  const double column = std::ldexp(1.0, column_shift_);
  columns_in_reach_ = static_cast<std::uint32_t>((units + slack) / column) + 1;
  reach_ = static_cast<float>(units);
  margin_ = units_of(margin);
  largest_size_ = units_of(bounds.largest_radius);
  shape_ = bounds.smallest_radius == bounds.largest_radius ? kernels::ElementShape::equal_spheres
                                                           : kernels::ElementShape::spheres;
}

template <int Dim>
void LayerGrid<Dim>::cut_rows_by_size(double margin) {
  column_shift_ = cell_shift_ - most_halvings;
  columns_ <<= most_halvings;
  columns_in_reach_ = kernels::near_columns;
  reach_ = kernels::near_reach;
  margin_ = units_of(margin);
  shape_ = kernels::ElementShape::spheres;
  is_by_size_ = true;
}

template <int Dim>
auto LayerGrid<Dim>::layers_around(const kernels::FarSphere& far) const noexcept -> LayerRange {
  // A whole number more than the reach, which no axis is longer than.
  constexpr float longest = 0x1p31f;
  const float reach = std::min(kernels::own_reach(far.radius, margin_), longest);
  const auto units = static_cast<std::int64_t>(double{reach} * (1.0 + 0x1p-18)) + 1;
  const std::int64_t position = far.position[map_.layer_axis];
  const std::int64_t first = std::max((position - units) >> map_.layer_shift, std::int64_t{0});
  const std::int64_t last =
      std::min((position + units) >> map_.layer_shift, std::int64_t{layers_} - 1);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
}

template <int Dim>
void LayerGrid<Dim>::set_layers(kernels::ThreeLayers& layers, std::size_t k) const noexcept {
  layers.row_axis = static_cast<int>(row_axis_);
  layers.next_row_axis = static_cast<int>(next_row_axis_);
  layers.layer_axis = map_.layer_axis;
  layers.cell_shift = cell_shift_;
  layers.column_shift = column_shift_;
  layers.columns = columns_;
  layers.layer = static_cast<std::int32_t>(k);
  layers.first_row = Dim == 2 ? static_cast<std::int32_t>(k * rows_) : 0;
  layers.margin = margin_;
  layers.largest_size = largest_size_;
}

template <int Dim>
void LayerGrid<Dim>::set_reach(kernels::LayerPair& layers) const noexcept {
  constexpr float slack = kernels::layer_slack;
  layers.nearest_margin = margin_ - slack;
  layers.farthest_margin = margin_ + slack;
  layers.largest_square = largest_square_;
  layers.shape = shape_;
  if (has_widths()) {
    layers.inner = layers.nearest_margin;
    layers.outer = layers.farthest_margin;
    layers.band = band_of_boxes;
    return;
  }
  const float nearest = std::max(reach_ - slack, 0.0f);
  const float farthest = reach_ + slack;
  layers.inner = nearest * nearest;
  layers.outer = farthest * farthest;
  // (s + 4)^2 - (s - 4)^2 = 16 s; roundings add less than 4 s, and s below the slack 64.
  layers.band = !has_radii() ? layers.outer - layers.inner : 20.0f * reach_ + 64.0f;
}

/// Joins rows to strips of 2^k rows each.
template <int Dim>
void LayerGrid<Dim>::join_rows(std::size_t elements) {
  const auto count = static_cast<double>(std::max<std::size_t>(elements, 1));
  const double in_row = count / static_cast<double>(rows_);
  const double in_four = std::min(4.0 * in_row, most_elements_of_four_rows);
  const double most = std::max(most_elements_of_strip, in_four);
  const double in_strip = std::min(most, count / least_strips);
  // A strip is a 24th of an axis at most, or one row, so that shifts by its bits stay below 31.
  int bits = 0;
  while (in_row * std::ldexp(1.0, bits + 1) <= in_strip) ++bits;
  layers_ = ((rows_ - 1) >> bits) + 1;
  row_mask_ = (std::uint32_t{1} << bits) - 1;
  map_.layer_shift += bits;
  rows_ = std::uint32_t{1} << bits;
}

template <int Dim>
double LayerGrid<Dim>::cells_joined() const noexcept {
  const double columns = 2.0 * columns_in_reach_ + 1.0;
  return 2.0 * std::ldexp(columns, column_shift_ - cell_shift_);
}

template class LayerGrid<2>;
template class LayerGrid<3>;

}  // namespace abut::engine
