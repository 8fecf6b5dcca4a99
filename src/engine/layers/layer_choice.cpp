#include "engine/layers/layer_choice.hpp"

#include "engine/box_in_cells.hpp"
#include "engine/layers/cell_by_size.hpp"
#include "engine/layers/coordinate_step.hpp"
#include "engine/layers/long_cells.hpp"
#include "engine/set_cells.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

/// Two sorted layers have places of 32 bits, and all elements might lie in them.
constexpr std::size_t most_elements = (std::size_t{1} << 31) - (std::size_t{1} << 19);

/// Cells of elements that look for smaller ones are not so small that an axis would have more:
/// their positions have bits for 2,044.
constexpr double most_cells_by_size = 2040.0;

/// Cells of two joined runs of nine columns, a quarter of a cell each.
constexpr double cells_joined_at_reach = 2.0 * 9.0 / 4.0;

template <int Dim>
bool are_boxes(const SearchInput<Dim>& input) {
  return input.spheres.stand_for_boxes();
}

/// Elements of a set that stand in layers: not the coarse ones, and in a level of sizes no others.
template <int Dim>
std::size_t elements_in_layers(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  return input.spheres.first(set.locals.size()).count_in_layers();
}

/// Tells whether elements pair with none but each other, and have places.
template <int Dim>
bool may_have_places(const SearchSet<Dim>& set) {
  return pair_with_none_but_each_other(set) && set.locals.are_the_first() &&
         set.locals.size() <= most_elements;
}

/// Returns a grid of cells, if there is one, for the elements in it.
template <int Dim>
std::optional<LayerGrid<Dim>> for_elements(std::optional<LayerGrid<Dim>> grid,
                                           const SearchInput<Dim>& input) {
  if (grid && are_boxes(input)) grid->hold_boxes();
  return grid;
}

/// Tells whether layers, or the rows of strips, hold enough elements to be worth their tables.
template <int Dim>
bool has_full_layers(const LayerGrid<Dim>& grid, const LayerLimits& limits, std::size_t elements) {
  double layers = grid.layer_count();
  if constexpr (Dim == 2) layers *= grid.row_count();
  return limits.least_elements_of_layer * layers <= static_cast<double>(elements);
}

/// Returns how many elements two joined runs may have.
template <int Dim>
double most_joined(const LayerGrid<Dim>& grid, const SearchInput<Dim>& input) {
  const LayerLimits& limits = input.layer_limits;
  const bool are_clusters = grid.has_wide_cells() && !input.spheres.are_moved();
  return are_clusters ? limits.most_joined_of_clusters : limits.most_joined;
}

/// Tells whether the box of a set has so many cells that clusters might fill a few of them.
template <int Dim>
bool is_nearly_empty(const SearchSet<Dim>& set, const LayerLimits& limits, double cell) {
  const double cells = limits.least_cells_of_clusters * static_cast<double>(set.locals.size());
  return BoxInCells<Dim>(set.bounds, cell).cells >= cells;
}

/// Tells whether cells that were widened may be narrower again: in cells of the size of the reach,
/// not nearly all would be empty.
template <int Dim>
bool may_be_narrow(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set,
                   const SearchInput<Dim>& input, double least_cell) {
  if (input.spheres.are_moved()) return grid.has_wide_cells();
  return grid.has_wide_cells() && !is_nearly_empty(set, input.layer_limits, least_cell);
}

/// Tells whether cells that were widened may be long instead: the wider they are, the more elements
/// share them. A coarse element looks in cubes.
template <int Dim>
bool may_be_long(const LayerGrid<Dim>& grid, double occupancy, const SearchInput<Dim>& input,
                 OccupancySample<Dim>& sample) {
  if (!grid.has_wide_cells() || !input.spheres.coarse().empty()) return false;
  const double wider = sample.mean_occupancy(CellsTwiceAsWide<Dim>{grid}, SampleSize::small);
  return wider - 1.0 >= input.layer_limits.least_growth_of_long * (occupancy - 1.0);
}

/// The fewest spheres, but for those whose distances are exact.
std::size_t fewest_spheres(const LayerLimits& limits) {
  return std::min({limits.least_elements, limits.least_elements_of_tiles,
                   limits.least_elements_of_clusters, limits.least_elements_of_dense});
}

/// The fewest elements of the shape that a search is given.
template <int Dim>
std::size_t fewest_elements(const SearchInput<Dim>& input) {
  const LayerLimits& limits = input.layer_limits;
  return are_boxes(input) ? limits.least_boxes_in(Dim) : fewest_spheres(limits);
}

/// Elements in two joined runs of another one, if all are spread equally.
template <int Dim>
double joined_if_equal(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set) {
  const double cells = BoxInCells<Dim>(set.bounds, grid.cell()).cells;
  return static_cast<double>(set.locals.size()) / cells * grid.cells_joined();
}

/// Tells whether so many elements are so crowded, even if they are spread equally, that tiles would
/// test many more.
template <int Dim>
bool are_crowded(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set, const LayerLimits& limits) {
  return set.locals.size() >= limits.least_elements_of_crowds &&
         joined_if_equal(grid, set) >= limits.least_joined_of_crowds;
}

/// Tells whether so many elements take less time than in tiles, whatever is special about them.
template <int Dim>
bool are_many(const SearchSet<Dim>& set, const SearchInput<Dim>& input, const LayerGrid<Dim>& grid,
              double least_cell) {
  const LayerLimits& limits = input.layer_limits;
  const std::size_t elements = elements_in_layers(set, input);
  if (input.spheres.are_moved() || elements >= limits.least_sparse_elements) return true;
  // Fewer than are worth it were refused before.
  if (are_boxes(input) || !input.spheres.coarse().empty()) return true;
  if (grid.cell() >= limits.least_sparse_cell * least_cell) return false;
  if (elements >= limits.least_elements || are_crowded(grid, set, limits)) return true;
  if (elements >= limits.least_elements_of_dense && !grid.has_wide_cells()) return true;
  return elements >= limits.least_elements_of_tiles &&
         cut_into_tiles(set, least_cell).tiles_in_box() > 1.0;
}

/// Elements in two joined runs of another one, on average.
template <int Dim>
double elements_joined(const LayerGrid<Dim>& grid, double occupancy) {
  return (occupancy - 1.0) * grid.cells_joined();
}

/// Tells whether vectors of joined runs hold most of them, and layers suit so many.
template <int Dim>
bool joined_fit_vectors(const LayerGrid<Dim>& grid, double occupancy,
                        const SearchInput<Dim>& input) {
  return elements_joined(grid, occupancy) <=
         std::min(input.layer_limits.most_joined_in_vectors, most_joined(grid, input));
}

/// Returns long cells, if there are some, whose runs have so few elements that they are worth more
/// than the grid.
template <int Dim>
std::optional<LayerGrid<Dim>> longer(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set,
                                     const SearchInput<Dim>& input, double least_cell,
                                     OccupancySample<Dim>& sample) {
  const LayerLimits& limits = input.layer_limits;
  const auto rods = choose_long_cells(set.bounds, input.margin, least_cell, sample);
  if (!rods) return std::nullopt;
  const double joined = joined_in_runs(*rods, SampleSize::full, sample);
  if (joined > most_joined(*rods, input)) return std::nullopt;
  const double joined_before = joined_in_runs(grid, SampleSize::full, sample);
  if (limits.least_gain_of_long * joined > joined_before) return std::nullopt;
  return for_elements(rods, input);
}

/// Returns the grid, or one of narrower or longer cells, whose joined runs have few enough
/// elements, if there is one.
template <int Dim>
std::optional<LayerGrid<Dim>> uncrowded(const LayerGrid<Dim>& grid, double occupancy,
                                        const SearchSet<Dim>& set, const SearchInput<Dim>& input,
                                        double least_cell, OccupancySample<Dim>& sample) {
  const LayerLimits& limits = input.layer_limits;
  const std::size_t elements = set.locals.size();
  const auto suits = [&](const LayerGrid<Dim>& cells, double its_occupancy) {
    return elements_joined(cells, its_occupancy) <= most_joined(cells, input);
  };
  std::optional<LayerGrid<Dim>> best;
  if (suits(grid, occupancy)) best = grid;
  if (elements_joined(grid, occupancy) <= limits.most_joined_in_vectors) return best;
  if (may_be_narrow(grid, set, input, least_cell)) {
    const auto narrow =
        for_elements(LayerGrid<Dim>::narrow(set.bounds, input.margin, least_cell, elements), input);
    if (narrow && has_full_layers(*narrow, limits, elements)) {
      const double its = sample.mean_occupancy(*narrow, SampleSize::full);
      if (limits.least_gain_of_narrow * its <= occupancy && suits(*narrow, its)) best = narrow;
    }
  }
  if (may_be_long(grid, occupancy, input, sample)) {
    const auto rods = longer(best ? *best : grid, set, input, least_cell, sample);
    if (rods) best = rods;
  }
  return best;
}

/// Tells whether layers are cut around crowds: so many elements are in one, and so unevenly, that
/// there are others within it.
template <int Dim>
bool may_be_crowded(const SearchSet<Dim>& set, const LayerLimits& limits, double least_cell,
                    OccupancySample<Dim>& sample) {
  const std::size_t elements = set.locals.size();
  if (set.bounds.largest_radius > limits.radii_of_parts * set.bounds.smallest_radius) return false;
  if (elements < limits.least_elements_of_one_crowd) return false;
  const auto count = static_cast<double>(elements);
  const ReachCells<Dim> cells(set.bounds, cell_for(set.bounds, least_cell, count));
  return sample.mean_occupancy(cells, SampleSize::small) > limits.least_part_of_one_crowd * count &&
         sample.unevenness() > limits.least_unevenness_of_crowd;
}

}  // namespace

bool may_be_in_layers(std::size_t elements, const LayerLimits& limits) noexcept {
  return elements >= std::min({fewest_spheres(limits), limits.least_elements_in_steps,
                               limits.least_elements_by_size, limits.least_elements_of_many_levels,
                               limits.least_elements_of_one_crowd, limits.least_boxes,
                               limits.least_rectangles});
}

template <int Dim>
bool pair_with_none_but_each_other(const SearchSet<Dim>& set) {
  return set.wanted == Wanted::all_pairs && set.halo.empty() && set.coarse_elements.empty();
}

template <int Dim>
bool may_be_in_steps(const SearchSet<Dim>& set, const SearchInput<Dim>& input, double least_cell) {
  return !are_boxes(input) && set.bounds.smallest_radius == set.bounds.largest_radius &&
         may_have_step<Dim>(input.given.spheres, steps_for(least_cell, input));
}

template <int Dim>
std::optional<LayerGrid<Dim>> choose_layers(const SearchSet<Dim>& set,
                                            const SearchInput<Dim>& input, double least_cell,
                                            OccupancySample<Dim>& sample) {
  const LayerLimits& limits = input.layer_limits;
  const std::size_t elements = elements_in_layers(set, input);
  if (!may_have_places(set) || !may_be_in_layers(elements, limits)) return std::nullopt;
  const bool may_be_exact = elements >= limits.least_elements_in_steps &&
                            elements < limits.least_elements &&
                            may_be_in_steps(set, input, least_cell);
  if (!may_be_exact && elements < fewest_elements(input)) return std::nullopt;
  const auto grid =
      for_elements(LayerGrid<Dim>::over(set.bounds, input.margin, least_cell, elements), input);
  if (!grid || !has_full_layers(*grid, limits, elements)) return std::nullopt;
  const bool are_enough = may_be_exact || are_many(set, input, *grid, least_cell);
  const bool may_be_clusters =
      elements >= limits.least_elements_of_clusters && grid->has_wide_cells();
  if (!are_enough && !may_be_clusters) return std::nullopt;
  if (elements <= limits.most_without_sample) return grid;
  double occupancy = sample.mean_occupancy(*grid, SampleSize::small);
  if (are_enough) {
    if (joined_fit_vectors(*grid, occupancy, input)) return grid;
    occupancy = sample.mean_occupancy(*grid, SampleSize::full);
  } else if (occupancy < limits.least_occupancy_of_clusters) {
    return std::nullopt;
  }
  return uncrowded(*grid, occupancy, set, input, least_cell, sample);
}

template <int Dim>
std::optional<LayerGrid<Dim>> layers_for_crowds(const SearchSet<Dim>& set,
                                                const SearchInput<Dim>& input, double least_cell,
                                                OccupancySample<Dim>& sample) {
  if (input.spheres.are_moved() || !may_have_places(set)) return std::nullopt;
  if (!input.part.is_part() && !may_be_crowded(set, input.layer_limits, least_cell, sample)) {
    return std::nullopt;
  }
  return for_elements<Dim>(
      LayerGrid<Dim>::of_crowds(set.bounds, input.margin, least_cell, input.part.widest_cell(),
                                elements_in_layers(set, input), input.part.rows_of_thin()),
      input);
}

template <int Dim>
double cost_of_element(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set,
                       const SearchInput<Dim>& input) {
  const LayerLimits& limits = input.layer_limits;
  const double joined = joined_if_equal(grid, set);
  if (Dim == 2 || are_boxes(input) || joined <= limits.most_joined_in_vectors) return 0.0;
  return limits.cost_in_blocks + limits.cost_of_joined * joined;
}

template <int Dim>
bool may_leave_out_coarse(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  if (input.spheres.are_moved()) return false;
  return set.locals.size() >= input.layer_limits.least_elements_beside_coarse &&
         may_have_places(set);
}

template <int Dim>
bool may_be_in_levels(const SearchSet<Dim>& set, const SearchInput<Dim>& input) {
  const grid::Bounds<Dim>& bounds = set.bounds;
  const double smallest = 2.0 * bounds.smallest_radius + input.margin;
  return !input.spheres.are_moved() && may_have_places(set) &&
         set.locals.size() >= input.layer_limits.least_elements_of_many_levels &&
         2.0 * smallest <= 2.0 * bounds.largest_radius + input.margin;
}

template <int Dim>
bool may_crowd_less_in_levels(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set,
                              const SearchInput<Dim>& input, OccupancySample<Dim>& sample) {
  if (!may_be_in_levels(set, input)) return false;
  const double joined = joined_in_runs(grid, SampleSize::full, sample);
  return joined > input.layer_limits.most_joined_without_levels;
}

template <int Dim>
bool may_have_clusters(const SearchSet<Dim>& set, const SearchInput<Dim>& input, double reach,
                       OccupancySample<Dim>& sample) {
  const LayerLimits& limits = input.layer_limits;
  const std::size_t elements = set.locals.size();
  if (input.spheres.are_moved() || !may_have_places(set) ||
      elements < limits.least_moved_elements || !is_nearly_empty(set, limits, reach)) {
    return false;
  }
  // Those that differ much in size are not searched in such cells.
  if (set.bounds.largest_radius > 2.0 * set.bounds.smallest_radius) return true;
  const double occupancy =
      sample.mean_occupancy(ReachCells<Dim>(set.bounds, reach), SampleSize::full);
  return (occupancy - 1.0) * cells_joined_at_reach <= limits.most_joined;
}

template <int Dim>
std::optional<LayerGrid<Dim>> choose_layers_by_size(const SearchSet<Dim>& set,
                                                    const SearchInput<Dim>& input,
                                                    const SizeEstimate& estimate,
                                                    OccupancySample<Dim>& sample) {
  const LayerLimits& limits = input.layer_limits;
  const std::size_t elements = set.locals.size();
  const std::size_t least =
      Dim == 3 && are_boxes(input) ? limits.least_boxes_by_size : limits.least_elements_by_size;
  if (!may_have_places(set) || elements < least) return std::nullopt;
  const CellBySize best = choose_cell_by_size<Dim>(estimate.classes, estimate.sizes, set.bounds);
  if (best.cell == 0.0 || !(best.cost <= limits.most_by_size * estimate.other_cost)) {
    return std::nullopt;
  }
  double cell = std::max(best.cell, estimate.least_cell);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double extent = set.bounds.upper[axis] - set.bounds.lower[axis];
    cell = std::max(cell, extent / most_cells_by_size);
  }
  const auto grid =
      for_elements(LayerGrid<Dim>::of_cells(set.bounds, input.margin, cell, elements), input);
  if (!grid || !has_full_layers(*grid, limits, elements)) return std::nullopt;
  const double occupancy = sample.mean_occupancy(*grid, SampleSize::full);
  if (occupancy - 1.0 > limits.most_crowded_by_size) return std::nullopt;
  return grid;
}

template bool pair_with_none_but_each_other(const SearchSet<2>&);
template bool pair_with_none_but_each_other(const SearchSet<3>&);
template bool may_be_in_steps(const SearchSet<2>&, const SearchInput<2>&, double);
template bool may_be_in_steps(const SearchSet<3>&, const SearchInput<3>&, double);
template bool may_be_in_levels(const SearchSet<2>&, const SearchInput<2>&);
template bool may_be_in_levels(const SearchSet<3>&, const SearchInput<3>&);
template bool may_leave_out_coarse(const SearchSet<2>&, const SearchInput<2>&);
template bool may_leave_out_coarse(const SearchSet<3>&, const SearchInput<3>&);
template std::optional<LayerGrid<2>> choose_layers(const SearchSet<2>&, const SearchInput<2>&,
                                                   double, OccupancySample<2>&);
template std::optional<LayerGrid<3>> choose_layers(const SearchSet<3>&, const SearchInput<3>&,
                                                   double, OccupancySample<3>&);
template std::optional<LayerGrid<2>> layers_for_crowds(const SearchSet<2>&, const SearchInput<2>&,
                                                       double, OccupancySample<2>&);
template std::optional<LayerGrid<3>> layers_for_crowds(const SearchSet<3>&, const SearchInput<3>&,
                                                       double, OccupancySample<3>&);
template double cost_of_element(const LayerGrid<2>&, const SearchSet<2>&, const SearchInput<2>&);
template double cost_of_element(const LayerGrid<3>&, const SearchSet<3>&, const SearchInput<3>&);
template bool may_crowd_less_in_levels(const LayerGrid<2>&, const SearchSet<2>&,
                                       const SearchInput<2>&, OccupancySample<2>&);
template bool may_crowd_less_in_levels(const LayerGrid<3>&, const SearchSet<3>&,
                                       const SearchInput<3>&, OccupancySample<3>&);
template bool may_have_clusters(const SearchSet<2>&, const SearchInput<2>&, double,
                                OccupancySample<2>&);
template bool may_have_clusters(const SearchSet<3>&, const SearchInput<3>&, double,
                                OccupancySample<3>&);
template std::optional<LayerGrid<2>> choose_layers_by_size(const SearchSet<2>&,
                                                           const SearchInput<2>&,
                                                           const SizeEstimate&,
                                                           OccupancySample<2>&);
template std::optional<LayerGrid<3>> choose_layers_by_size(const SearchSet<3>&,
                                                           const SearchInput<3>&,
                                                           const SizeEstimate&,
                                                           OccupancySample<3>&);

}  // namespace abut::engine
