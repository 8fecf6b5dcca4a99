#pragma once

#include "base/detection_context.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/layers/occupancy_sample.hpp"
#include "engine/search_set.hpp"
#include "engine/size_classes.hpp"
#include "engine/tile_searcher.hpp"
#include "engine/workspace.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::engine {

/// Returns the grid of layers for a search set if they suit it: spheres of one radius, spread
/// evenly enough, that meet none but each other.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> choose_layers(const SearchSet<Dim>& set,
                                                          const SearchInput<Dim>& input,
                                                          double least_cell,
                                                          OccupancySample& sample);

/// Tells whether a search set may be moved cluster by cluster: in cells of the size of the reach
/// nearly all of its box is empty, and where it is not, elements do not crowd.
template <int Dim>
[[nodiscard]] bool may_have_clusters(const SearchSet<Dim>& set, const SearchInput<Dim>& input,
                                     double reach, OccupancySample& sample);

/// Returns the grid of such layers in which all distances are exact, if the elements as given have
/// coordinates that allow it: no pair will be left undecided.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> layers_in_steps(const SearchSet<Dim>& set,
                                                            const SearchInput<Dim>& input,
                                                            const LayerGrid<Dim>& grid,
                                                            std::size_t workers,
                                                            base::WorkCounter& work);

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
                                                                  OccupancySample& sample);

/// Searches a search set layer by layer, by all workers, each of which takes stretches of layers
/// that follow each other.
template <int Dim>
class LayerSearch {
 public:
  LayerSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace, std::size_t workers,
              base::DetectionContext& context)
      : input_(input), workspace_(workspace), worker_count_(workers), context_(context) {}

  /// Units of work are counted on from `unit`; returns the next one.
  [[nodiscard]] std::uint64_t search(const SearchSet<Dim>& set, const LayerGrid<Dim>& grid,
                                     std::uint64_t unit);

 private:
  [[nodiscard]] LayerItems what_to_sort(const LayerSpheres<Dim>& spheres,
                                        const LayerGrid<Dim>& grid) const;
  [[nodiscard]] std::size_t workers_for(const LayerGrid<Dim>& grid, std::size_t elements) const;
  void search_stretch(const LayerGrid<Dim>& grid, std::size_t first, std::size_t last,
                      TileSearcher<Dim>& worker, base::WorkCounter& work);
  void search_stretch_by_size(const LayerGrid<Dim>& grid, std::size_t first, std::size_t last,
                              TileSearcher<Dim>& worker, base::WorkCounter& work);

  const SearchInput<Dim>& input_;
  Workspace<Dim>& workspace_;
  std::size_t worker_count_;
  base::DetectionContext& context_;
  std::atomic<std::size_t> layers_with_many_undecided_{0};
};

}  // namespace abut::engine
