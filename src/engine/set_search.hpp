#pragma once

#include "base/detection_context.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/search_worker.hpp"
#include "engine/sizes/size_classes.hpp"
#include "engine/workspace.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace abut::engine {

/// Searches search sets: few elements in a plane, divides others by size where that pays, searches
/// large ones in layers where these suit, cuts the others into tiles, searches each tile, and
/// treats a crowded tile as a search set of its own.
///
/// Search sets are searched by all workers together, tile by tile; the search sets inside a tile by
/// the worker whose tile it is, but for large ones, which wait until all are free. What comes of a
/// search set waits until its search has ended, and is searched in the same arrays.
template <int Dim>
class SetSearch {
 public:
  SetSearch(const SearchInput<Dim>& input, Workspace<Dim>& workspace, std::size_t workers,
            base::DetectionContext& context);

  /// The same of a part of a set. Units of work are counted on from `unit`.
  SetSearch(const SearchInput<Dim>& part, Workspace<Dim>& workspace, std::size_t workers,
            base::DetectionContext& context, std::uint64_t unit);

  void search(const SearchSet<Dim>& set);

  /// Searches the set in a plane or in layers if they suit it; returns whether it did.
  [[nodiscard]] bool search_in_layers(const SearchSet<Dim>& set);

  /// Searches a part of a set, in layers.
  void search_part(const SearchSet<Dim>& set);
  [[nodiscard]] std::uint64_t next_unit() const noexcept { return next_unit_; }

 private:
  /// What workers share in the search of a set: its tiles; the layers of its only tile; or nothing,
  /// where it came of a tile that one of them has.
  enum class Parallel { tiles, layers, nothing };

  /// The workers that search a search set or a tile of it, and the arrays of what comes of it.
  struct SearchPlace {
    SearchWorker<Dim>* worker;  ///< none: all, each tiles of its own
    Tiles<Dim>& tiles;
    SetScratch<Dim>& sets;
    Parallel parallel;
  };

  /// A search set that came of a crowded tile while all workers searched.
  struct FoundSet {
    std::size_t tile;
    WaitingSet<Dim> set;
  };

  /// Counter of the worker that searches at a place; where all workers do, that of the caller's
  /// thread.
  [[nodiscard]] base::WorkCounter& work_at(const SearchPlace& at) const noexcept {
    return (at.worker != nullptr ? at.worker : workspace_.workers[0].get())->work();
  }

  /// What came of a look at the sizes in a set.
  struct SizeChoice {
    std::optional<double> cut;
    bool is_searched = false;  ///< in layers, by size
    /// Of an element in tiles, in candidate tests, if sizes differ.
    double cost_in_tiles = std::numeric_limits<double>::infinity();
  };

  /// A level of sizes and the layers that suit it.
  struct LevelInLayers {
    std::size_t number;
    LayerGrid<Dim> layers;
  };

  [[nodiscard]] static SearchPlace place_of(SearchWorker<Dim>& worker, Parallel parallel) {
    return {&worker, worker.scratch().tiles, worker.scratch().sets, parallel};
  }

  void start_workers(const SearchInput<Dim>& input);
  void finish();
  [[nodiscard]] SearchPlace place_of_all() {
    return {nullptr, workspace_.tiles, workspace_.sets, Parallel::tiles};
  }
  [[nodiscard]] std::optional<LayerGrid<Dim>> layers_for(const SearchSet<Dim>& set);
  [[nodiscard]] std::optional<LayerGrid<Dim>> layers_of_part(const SearchSet<Dim>& part,
                                                             const SearchInput<Dim>& input);
  void sample_from(const SearchSet<Dim>& set, const SearchInput<Dim>& input);
  [[nodiscard]] bool take_layers(const SearchSet<Dim>& set, const SizeChoice& choice);
  [[nodiscard]] bool take_whole(const SearchSet<Dim>& set, const SizeChoice& choice);
  [[nodiscard]] bool take_in_plane(const SearchSet<Dim>& set);
  [[nodiscard]] bool take_levels(const SearchSet<Dim>& set);
  [[nodiscard]] SearchInput<Dim> input_of_level(const SearchSet<Dim>& set, std::size_t level) const;
  [[nodiscard]] std::optional<std::vector<LevelInLayers>> layers_of_levels(
      const SearchSet<Dim>& set);
  [[nodiscard]] bool take_clusters(const SearchSet<Dim>& set);
  [[nodiscard]] bool take_without_coarse(const SearchSet<Dim>& set, double cut);
  [[nodiscard]] std::optional<LayerGrid<Dim>> crowded_layers_for(const SearchSet<Dim>& set);
  [[nodiscard]] bool take_crowded(const SearchSet<Dim>& set);
  void search_crowds(const SearchSet<Dim>& set, const LayerGrid<Dim>& layers);
  void search_layers(const SearchSet<Dim>& set, const LayerGrid<Dim>& layers);

  void count_radii_of(const SearchSet<Dim>& set, const SearchPlace& at);
  void share_radii(std::size_t elements, const SearchPlace& at);
  [[nodiscard]] SizeChoice choose_by_size(const SearchSet<Dim>& set, const SearchPlace& at);
  [[nodiscard]] double cost_in_tiles(const SearchSet<Dim>& set, double tests) const;
  [[nodiscard]] bool search_beside_coarse(const SearchSet<Dim>& set, const SizeClasses& classes,
                                          const SizeDistribution& sizes, double other_cost);
  [[nodiscard]] bool search_by_size(const SearchSet<Dim>& set, const SizeClasses& classes,
                                    const SizeDistribution& sizes, double other_cost);
  void search(const SearchSet<Dim>& set, const SearchPlace& at);
  void search_divided(const SearchSet<Dim>& set, double cut, const SearchPlace& at);
  [[nodiscard]] TileGrid<Dim> sort_into_tiles(const SearchSet<Dim>& set, std::size_t workers,
                                              const SearchPlace& at);
  void search_tiles(const SearchSet<Dim>& set, const SearchPlace& at);
  void search_one_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid);
  void search_pairs(double unit, const SearchPlace& at);
  void search_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid, const Tiles<Dim>& tiles,
                   std::size_t tile, const SearchPlace& at);
  bool take_crowded_tile(const SearchSet<Dim>& set, const TileGrid<Dim>& grid,
                         const Tiles<Dim>& tiles, std::size_t tile, const TileCells<Dim>& cells,
                         const SearchPlace& at);
  [[nodiscard]] std::optional<double> size_cut_in(const SearchSet<Dim>& set,
                                                  const TileGrid<Dim>& grid,
                                                  const Tiles<Dim>& tiles, std::size_t tile,
                                                  const TileCells<Dim>& cells,
                                                  const SearchPlace& at) const;
  void search_waiting(const SearchPlace& at);
  void search(const WaitingSet<Dim>& next, const SearchPlace& at);
  void search_by_first(const WaitingSet<Dim>& next);
  [[nodiscard]] std::unique_ptr<Members> spare_of_all(const MemberCounts& most);
  void let_found_wait();

  const SearchInput<Dim>& given_;
  std::optional<SearchInput<Dim>> moved_;  ///< the same with its clusters moved
  const SearchInput<Dim>* input_;          ///< the one that is searched
  Workspace<Dim>& workspace_;
  std::size_t worker_count_;
  base::DetectionContext& context_;
  std::uint64_t next_unit_ = 0;
  std::mutex found_mutex_;
  std::vector<FoundSet> found_;
};

}  // namespace abut::engine
