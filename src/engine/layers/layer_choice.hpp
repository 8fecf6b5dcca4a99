#pragma once

#include "engine/layers/layer_grid.hpp"
#include "engine/layers/layer_limits.hpp"
#include "engine/layers/occupancy_sample.hpp"
#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
#include "engine/sizes/size_classes.hpp"

#include <cstddef>
#include <optional>

namespace abut::engine {

/// Tells whether so many elements may be searched in layers, whatever they are like.
[[nodiscard]] bool may_be_in_layers(std::size_t elements, const LayerLimits& limits) noexcept;

/// Tells whether no other elements take part in the pairs of a search set.
template <int Dim>
[[nodiscard]] bool pair_with_none_but_each_other(const SearchSet<Dim>& set);

/// Tells whether distances may be exact in cells of that size or wider.
template <int Dim>
[[nodiscard]] bool may_be_in_steps(const SearchSet<Dim>& set, const SearchInput<Dim>& input,
                                   double least_cell);

/// Returns the grid of layers for a search set if they suit it: spheres of one radius, spread
/// evenly enough, that meet none but each other.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> choose_layers(const SearchSet<Dim>& set,
                                                          const SearchInput<Dim>& input,
                                                          double least_cell,
                                                          OccupancySample<Dim>& sample);

/// Returns the grid of layers for a set that is crowded in parts, which become sets of their own,
/// if it is crowded enough: layers suit these however they are spread, on axes of any length. For a
/// part of a set there always is one.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> layers_for_crowds(const SearchSet<Dim>& set,
                                                              const SearchInput<Dim>& input,
                                                              double least_cell,
                                                              OccupancySample<Dim>& sample);

/// Returns what these layers cost an element of a set whose sizes differ, in candidate tests of
/// tiles, if all are spread equally. That is nothing where runs are short, as they are in 2D, and
/// for boxes, which have more candidates in tiles: no other search is faster then.
template <int Dim>
[[nodiscard]] double cost_of_element(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set,
                                     const SearchInput<Dim>& input);

/// Tells whether a search set may be searched in layers without its coarse elements: it is large,
/// its elements pair with none but each other, and they are where they are given. A coarse element
/// may meet several clusters, and these are moved apart.
template <int Dim>
[[nodiscard]] bool may_leave_out_coarse(const SearchSet<Dim>& set, const SearchInput<Dim>& input);

/// Tells whether a search set may be searched in levels of sizes, each in layers of its own.
template <int Dim>
[[nodiscard]] bool may_be_in_levels(const SearchSet<Dim>& set, const SearchInput<Dim>& input);

/// Tells whether elements of many sizes crowd so much in layers of one reach that levels, if they
/// suit, take less time.
template <int Dim>
[[nodiscard]] bool may_crowd_less_in_levels(const LayerGrid<Dim>& grid, const SearchSet<Dim>& set,
                                            const SearchInput<Dim>& input,
                                            OccupancySample<Dim>& sample);

/// Tells whether a search set may be moved cluster by cluster: in cells of the size of the reach
/// nearly all of its box is empty, and where it is not, elements do not crowd.
template <int Dim>
[[nodiscard]] bool may_have_clusters(const SearchSet<Dim>& set, const SearchInput<Dim>& input,
                                     double reach, OccupancySample<Dim>& sample);

/// What is known of the sizes in a search set.
struct SizeEstimate {
  const SizeClasses& classes;
  const SizeDistribution& sizes;
  double other_cost;  ///< of the best search without layers by size, in candidate tests
  double least_cell;
};

/// Returns the grid of layers for a search set whose spheres differ in size, each of which looks
/// for smaller ones, if they suit it and cost less than other searches.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> choose_layers_by_size(const SearchSet<Dim>& set,
                                                                  const SearchInput<Dim>& input,
                                                                  const SizeEstimate& estimate,
                                                                  OccupancySample<Dim>& sample);

}  // namespace abut::engine
