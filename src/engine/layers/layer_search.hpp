#pragma once

#include "base/detection_context.hpp"
#include "engine/crowds/crowds_of_layers.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/search_set.hpp"
#include "engine/search_worker.hpp"
#include "engine/workspace.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Who finds the pairs of two coarse elements: the search to which these belong, or another one.
enum class CoarsePairs { searched, left_out };

/// Searches a search set layer by layer, by all workers, each of which takes stretches of layers
/// that follow each other.
template <int Dim>
class LayerSearch {
 public:
  LayerSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace, std::size_t workers,
              base::DetectionContext& context)
      : input_(input), workspace_(workspace), worker_count_(workers), context_(context) {}

  /// Leaves the crowds of layers to a way of searching them, which must outlive this.
  void leave_crowds_to(CrowdsOfLayers<Dim>& crowds) noexcept { crowds_ = &crowds; }

  /// Units of work are counted on from `unit`; returns the next one.
  [[nodiscard]] std::uint64_t search(const SearchSet<Dim>& set, const LayerGrid<Dim>& grid,
                                     std::uint64_t unit,
                                     CoarsePairs coarse_pairs = CoarsePairs::searched);

 private:
  [[nodiscard]] LayerItems what_to_sort(const LayerSpheres<Dim>& spheres,
                                        const LayerGrid<Dim>& grid) const;
  [[nodiscard]] std::size_t workers_for(const LayerGrid<Dim>& grid, std::size_t elements) const;
  [[nodiscard]] bool has_coarse() const noexcept { return !input_.spheres.coarse().empty(); }
  void sort_coarse(const LayerGrid<Dim>& grid);
  [[nodiscard]] std::uint64_t search_coarse_pairs(const LayerGrid<Dim>& grid, std::uint64_t unit);
  [[nodiscard]] LayerElements<Dim> elements_of(const LayerGrid<Dim>& grid, std::size_t k,
                                               SearchWorker<Dim>& worker) const;
  [[nodiscard]] std::size_t largest_layer() const;
  void search_stretch(const LayerGrid<Dim>& grid, std::size_t first, std::size_t last,
                      SearchWorker<Dim>& worker, base::WorkCounter& work);
  void search_stretch_by_size(const LayerGrid<Dim>& grid, std::size_t first, std::size_t last,
                              SearchWorker<Dim>& worker, base::WorkCounter& work);

  const SearchInput<Dim>& input_;
  Workspace<Dim>& workspace_;
  std::size_t worker_count_;
  base::DetectionContext& context_;
  CrowdsOfLayers<Dim>* crowds_ = nullptr;  ///< null: layers are searched as they are
  std::atomic<std::size_t> layers_with_many_undecided_{0};
};

}  // namespace abut::engine
