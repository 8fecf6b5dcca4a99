#pragma once

#include "base/detection_context.hpp"
#include "engine/tile_searcher.hpp"
#include "engine/workspace.hpp"

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace abut::engine {

/// Searches groups: divides them by size where that pays, cuts them into tiles, searches each tile,
/// and treats a crowded tile as a group of its own.
///
/// Groups are searched by all workers together, tile by tile; the groups inside a tile by the
/// worker whose tile it is, but for large ones, which wait until all are free.
template <int Dim>
class GroupSearch {
 public:
  GroupSearch(const Task<Dim>& task, Workspace<Dim>& workspace, std::size_t workers,
              base::DetectionContext& context);

  void search(const Group<Dim>& group);

 private:
  /// Who searches the pairs of a tile: the one who sorts it, or all.
  enum class Crew { one, all };

  /// Who searches a group, and at which depth of which floors.
  struct Post {
    TileSearcher<Dim>* worker;  ///< none: all, each tiles of its own
    Floors<Dim>& floors;
    RadiusHistogram& histogram;
    std::size_t depth;
    Crew crew = Crew::one;

    [[nodiscard]] Post deeper() const { return {worker, floors, histogram, depth + 1}; }
  };

  /// A crowded tile that becomes a group of its own.
  struct Part {
    Group<Dim> group;
    std::optional<double> size_cut;
  };

  struct Waiting {
    std::size_t tile;
    Part part;
  };

  /// Of who is at that post: of all workers, the caller's thread.
  [[nodiscard]] base::WorkCounter& work_at(const Post& post) const noexcept {
    return (post.worker != nullptr ? post.worker : workspace_.workers[0].get())->work();
  }

  void search(const Group<Dim>& group, const Post& post);
  void search(const Part& part, const Post& post);
  void search_divided(const Group<Dim>& group, double cut, const Post& post);
  void search_tiles(const Group<Dim>& group, const Post& post);
  void search_one_tile(const Group<Dim>& group, const TileGrid<Dim>& grid, const Tiles<Dim>& tiles,
                       const Post& post);
  void search_pairs(double unit, const Post& post);
  void search_tile(const Group<Dim>& group, const TileGrid<Dim>& grid, const Tiles<Dim>& tiles,
                   std::size_t tile, const Post& post);
  bool search_crowded_tile(const Group<Dim>& group, const TileGrid<Dim>& grid,
                           const Tiles<Dim>& tiles, std::size_t tile, const TileCells<Dim>& cells,
                           const Post& post);
  [[nodiscard]] std::optional<double> size_cut_in(const Group<Dim>& group,
                                                  const TileGrid<Dim>& grid,
                                                  const Tiles<Dim>& tiles, std::size_t tile,
                                                  const TileCells<Dim>& cells,
                                                  const Post& post) const;
  void search_waiting(const Post& post);
  [[nodiscard]] Members& spare_members();

  const Task<Dim>& task_;
  Workspace<Dim>& workspace_;
  std::size_t worker_count_;
  base::DetectionContext& context_;
  std::uint64_t next_unit_ = 0;
  std::mutex waiting_mutex_;
  std::vector<Waiting> waiting_;
  std::size_t deferred_in_use_ = 0;
};

}  // namespace abut::engine
