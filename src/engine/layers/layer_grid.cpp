#include "engine/layers/layer_grid.hpp"

#include "engine/box_in_cells.hpp"
#include "engine/layers/largest_square.hpp"
#include "engine/layers/layer_units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace abut::engine {
namespace {

/// Columns are cells / 2^k: so narrow that two runs seldom have more elements than a vector has
/// lanes, so wide that their table is not longer than the elements' own columns.
constexpr int most_halvings = 2;
/// Cells that are wider than the reach by more than this have half as many columns.
constexpr double wide_cell = 1.5;

/// Elements of a strip in 2D, at most, which is sorted within the nearest caches; the same of up to
/// four long rows, for a table has two rows besides; and strips, at least, that workers may share
/// out, if these have so many elements.
constexpr double most_elements_of_strip = 4096.0;
constexpr double least_elements_of_strip = 512.0;
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

/// Rows of all layers, layers, and columns with those beside a row, that long cells have for each
/// element, at most. Each row ends with eight places; where cells are rods, that is worth more
/// rows.
constexpr double most_rods_of_element = 0.5;
constexpr double most_rows_of_element = 0.125;
constexpr double most_layers_of_element = 0.125;
constexpr double most_columns_of_element = 12.0;

/// Layers of long cells, in 2D rows, at least: two of them must be a small part of all.
constexpr double least_layers_of_long = 24.0;

/// Cells of an axis that positions have bits for: a little fewer.
constexpr double most_cells_of_axis = 32730.0;

/// Cells of a crowded set, for each of its elements: most are empty, and where they are not, they
/// are cut anew.
constexpr double cells_of_crowded_element = 2.0;

/// Elements of a slice of a long axis, on average. Layers of fewer elements than the third number
/// are thin: where a set is no longer than two slices, rows go along its longest axis then.
constexpr double elements_of_slice = 16000.0;
constexpr std::size_t elements_of_two_slices = 32000;
constexpr std::size_t elements_of_thick_layer = 8;

/// Columns of such rows, for each element: tables of two layers have six times as many entries.
constexpr std::size_t most_columns_of_long_rows = 1;

/// What a run reaches beyond the reach, for positions are rounded.
constexpr double slack_of_runs = 2.0 * double{kernels::layer_slack};

/// The axes by extent for long cells: all but the long one remain in this order.
template <int Dim>
std::array<std::size_t, Dim> axes_of(const LongCells& shape, const grid::Bounds<Dim>& bounds) {
  const std::size_t its_place = shape.along == LongCells::Along::rows ? Dim - 2 : 0;
  std::array<std::size_t, Dim> axes{};
  axes[its_place] = shape.axis;
  std::size_t place = its_place == 0 ? 1 : 0;
  for (const std::size_t axis : axes_by_extent(bounds)) {
    if (axis == shape.axis) continue;
    axes[place] = axis;
    place = Dim - 1;
  }
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
LayerGrid<Dim> LayerGrid<Dim>::of_crowds(const grid::Bounds<Dim>& bounds, double margin,
                                         double least_cell, double widest_cell,
                                         std::size_t elements, RowsOfThin rows) {
  const auto count = static_cast<double>(elements);
  const double longest = longest_axis(bounds);
  double cell = std::max(cell_size(bounds, least_cell, cells_of_crowded_element * count),
                         longest / most_cells_of_axis);
  const bool is_thin = static_cast<double>(elements_of_thick_layer) * longest > count * cell;
  if (is_thin && elements >= elements_of_two_slices) {
    const double slice = std::max(cell, longest / std::floor(count / elements_of_slice));
    if (slice <= widest_cell) cell = slice;
  }
  if (cell <= widest_cell) rows = RowsOfThin::along;
  // No axis has more cells than positions have bits for.
  return of_reach(bounds, margin, least_cell, cell, elements, rows).value();
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
                                                       double cell, std::size_t elements,
                                                       RowsOfThin rows) {
  LayerGrid grid;
  const LayerUnits units = units_for(bounds, cell, least_cell);
  if (!grid.lay_out(bounds, std::ldexp(1.0, units.cell_shift) / cell, units)) return std::nullopt;
  grid.has_wide_cells_ = cell > least_cell;
  const bool are_thin = elements_of_thick_layer * grid.layers_ > elements;
  grid.has_long_rows_ = are_thin && elements < elements_of_two_slices && rows == RowsOfThin::along;
  if (grid.has_long_rows_) {
    auto axes = axes_by_extent(bounds);
    std::swap(axes[Dim - 2], axes[Dim - 1]);
    grid.turn(axes);
  }
  grid.cut_rows(bounds, margin, slack_of_runs);
  if (grid.has_long_rows_) grid.cut_long_rows(elements);
  if constexpr (Dim == 2) grid.join_rows(elements);
  return grid;
}

template <int Dim>
std::optional<LayerGrid<Dim>> LayerGrid<Dim>::of_long_cells(const grid::Bounds<Dim>& bounds,
                                                            double margin, double least_cell,
                                                            std::size_t elements,
                                                            const LongCells& shape) {
  const double cell = std::max(least_cell, longest_axis(bounds) / most_cells_of_axis);
  const LayerUnits units = units_for(bounds, cell, least_cell);
  LayerGrid grid;
  if (!grid.lay_out(bounds, std::ldexp(1.0, units.cell_shift) / cell, units)) return std::nullopt;
  grid.has_wide_cells_ = true;
  grid.has_long_cells_ = true;
  grid.turn(axes_of(shape, bounds));
  grid.cut_rows(bounds, margin, slack_of_runs);
  grid.widen_cells(elements, shape.along);
  if (grid.layers_ < least_layers_of_long) return std::nullopt;
  if constexpr (Dim == 2) grid.join_rows(elements);
  return grid;
}

/// Widens layers, rows and columns until there are few enough for the elements. Where cells are
/// long from row to row, rows are widened before columns; where they are rods, rows and layers
/// alike, and columns take what is left.
template <int Dim>
void LayerGrid<Dim>::widen_cells(std::size_t elements, LongCells::Along along) noexcept {
  const auto count = static_cast<double>(elements);
  const bool are_rods = Dim == 3 && along == LongCells::Along::rows;
  const double most_rows = count * (are_rods ? most_rods_of_element : most_rows_of_element);
  const auto have_long_tables = [&] {
    return rows_of_all() * (columns_ + 2.0 * columns_in_reach_) > most_columns_of_element * count;
  };
  while (layers_ > 1 && layers_ > most_layers_of_element * count) widen_layers();
  while (rows_ > 1 &&
         (rows_of_all() > most_rows || (Dim == 3 && !are_rods && have_long_tables()))) {
    widen_rows();
    if (are_rods) widen_layers();
  }
  while (columns_ > 1 && have_long_tables()) cut_columns(column_shift() + 1, slack_of_runs);
}

/// In 2D a layer is a row until rows are joined.
template <int Dim>
void LayerGrid<Dim>::widen_layers() noexcept {
  ++map_.layer_shift;
  layers_ = ((layers_ - 1) >> 1) + 1;
  if constexpr (Dim == 2) row_map_.row_shift = map_.layer_shift;
  if constexpr (Dim == 2) rows_ = layers_;
}

template <int Dim>
void LayerGrid<Dim>::widen_rows() noexcept {
  ++row_map_.row_shift;
  rows_ = ((rows_ - 1) >> 1) + 1;
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
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    map_.lower[axis] = bounds.lower[axis];
    const double last = (bounds.upper[axis] - bounds.lower[axis]) * map_.units_of_one;
    if (!(last < end)) return false;
    cells_[axis] = (static_cast<std::uint32_t>(last) >> cell_shift_) + 1;
  }
  turn(axes_by_extent(bounds));
  return true;
}

/// Lets the last axis go from layer to layer, and the one before it along the rows.
template <int Dim>
void LayerGrid<Dim>::turn(const std::array<std::size_t, Dim>& axes) {
  const std::size_t layer_axis = axes[Dim - 1];
  map_.layer_axis = static_cast<int>(layer_axis);
  map_.layer_shift = cell_shift_;
  row_map_.row_shift = cell_shift_;
  row_map_.row_axis = static_cast<int>(axes[Dim - 2]);
  row_map_.next_row_axis = static_cast<int>(Dim == 2 ? layer_axis : axes[0]);
  layers_ = cells_[layer_axis];
  rows_ = cells_[next_row_axis()];
}

template <int Dim>
void LayerGrid<Dim>::cut_rows(const grid::Bounds<Dim>& bounds, double margin, double slack) {
  const double reach = bounds.largest_radius + bounds.second_largest_radius + margin;
  const double cell = std::ldexp(1.0, cell_shift_);
  reach_ = reach * map_.units_of_one;
  const bool is_wide = cell > wide_cell * reach_;
  cut_columns(cell_shift_ - (is_wide ? most_halvings - 1 : most_halvings), slack);
  margin_ = units_of(margin);
  largest_size_ = units_of(bounds.largest_radius);
  shape_ = bounds.smallest_radius == bounds.largest_radius ? kernels::ElementShape::equal_spheres
                                                           : kernels::ElementShape::spheres;
}

/// Cuts rows that have more cells than all that are beside them.
template <int Dim>
void LayerGrid<Dim>::cut_long_rows(std::size_t elements) noexcept {
  int shift = cell_shift_ - 1;
  do cut_columns(shift++, slack_of_runs);
  while (columns_ > most_columns_of_long_rows * elements);
}

/// Cuts rows into columns of 2^shift units.
template <int Dim>
void LayerGrid<Dim>::cut_columns(int shift, double slack) noexcept {
  row_map_.column_shift = shift;
  const int halvings = cell_shift_ - shift;
  const std::uint32_t cells = cells_[row_axis()];
  columns_ = halvings >= 0 ? cells << halvings : ((cells - 1) >> -halvings) + 1;
  columns_in_reach_ = static_cast<std::uint32_t>(std::ldexp(reach_ + slack, -shift)) + 1;
}

template <int Dim>
void LayerGrid<Dim>::cut_rows_by_size(double margin) {
  cut_columns(cell_shift_ - most_halvings, 0.0);
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
  layers.row_axis = row_map_.row_axis;
  layers.next_row_axis = row_map_.next_row_axis;
  layers.layer_axis = map_.layer_axis;
  layers.cell_shift = cell_shift_;
  layers.column_shift = column_shift();
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
  const auto reach = static_cast<float>(reach_);
  const float nearest = std::max(reach - slack, 0.0f);
  const float farthest = reach + slack;
  layers.inner = nearest * nearest;
  layers.outer = farthest * farthest;
  // (s + 4)^2 - (s - 4)^2 = 16 s; roundings add less than 4 s, and s below the slack 64.
  layers.band = !has_radii() ? layers.outer - layers.inner : 20.0f * reach + 64.0f;
}

/// Joins rows to strips of 2^k rows each.
template <int Dim>
void LayerGrid<Dim>::join_rows(std::size_t elements) {
  const auto count = static_cast<double>(std::max<std::size_t>(elements, 1));
  const double in_row = count / static_cast<double>(rows_);
  const double in_four = std::min(4.0 * in_row, most_elements_of_four_rows);
  const double most = std::max(most_elements_of_strip, in_four);
  const double least = std::min(least_elements_of_strip, 0.5 * count);
  const double in_strip = std::min(most, std::max(count / least_strips, least));
  // A strip has half of the rows at most, or is one, so that shifts by its bits stay below 31.
  int bits = 0;
  while (in_row * std::ldexp(1.0, bits + 1) <= in_strip) ++bits;
  layers_ = ((rows_ - 1) >> bits) + 1;
  row_map_.row_mask = (std::uint32_t{1} << bits) - 1;
  map_.layer_shift += bits;
  rows_ = std::uint32_t{1} << bits;
}

template <int Dim>
double LayerGrid<Dim>::cells_joined() const noexcept {
  const double columns = 2.0 * columns_in_reach_ + 1.0;
  return 2.0 * std::ldexp(columns, column_shift() - cell_shift_);
}

template class LayerGrid<2>;
template class LayerGrid<3>;

}  // namespace abut::engine
