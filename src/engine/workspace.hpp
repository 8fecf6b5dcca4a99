#pragma once

#include "base/memory_meter.hpp"
#include "engine/clusters/clusters.hpp"
#include "engine/crowds/layer_crowds.hpp"
#include "engine/crowds/part_workspaces.hpp"
#include "engine/crowds/waiting_parts.hpp"
#include "engine/layers/coarse_elements.hpp"
#include "engine/layers/far_spheres.hpp"
#include "engine/layers/layer_records.hpp"
#include "engine/layers/occupancy_sample.hpp"
#include "engine/layers/size_levels.hpp"
#include "engine/memory_law.hpp"
#include "engine/plane/plane_rows.hpp"
#include "engine/search_worker.hpp"
#include "engine/worker_scratch.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut::engine {

/// How the last search went that was not one of a part.
struct LastSearch {
  std::size_t most_in_layers = 0;   ///< elements of the largest set in layers
  std::size_t in_plane = 0;         ///< elements, if they were in a plane
  bool must_be_packed = false;      ///< so few that a plane might have suited them
  std::size_t clusters_moved = 0;   ///< 0 where elements stayed in their places
  std::size_t beside_layers = 0;    ///< coarse elements without which it was done
  std::size_t levels_of_sizes = 0;  ///< 0 where there were none
};

/// All arrays of the engine. Kept from one detection to the next, it makes the next one free of
/// allocations.
template <int Dim>
struct Workspace {
  /// The first of its workers has this number: that of the worker for which it is made, if it is
  /// not for all.
  explicit Workspace(base::MemoryMeter& meter, std::size_t first = 0)
      : memory(meter),
        first_worker(first),
        tiles(meter),
        sets(meter),
        layer_records(meter),
        far_spheres(meter),
        coarse(meter),
        size_levels(meter),
        occupancy(meter),
        clusters(meter),
        plane(meter),
        layer_crowds(meter),
        of_parts(meter) {}

  void expect_workers(std::size_t count) {
    while (workers.size() < count) {
      workers.push_back(std::make_unique<SearchWorker<Dim>>(memory, first_worker + workers.size()));
    }
    of_parts.expect_workers(count);
  }

  /// Notes that so many elements are searched. What an earlier search was allowed stays so.
  void expect_elements(std::size_t elements, std::size_t worker_count) noexcept {
    much_memory = std::max(much_memory, engine::much_memory<Dim>(elements, worker_count));
  }
  /// Frees the arrays of a worker that has searched a tile where much memory is in use: each of
  /// many workers may have had a large one. The first one, who is alone in most calls, keeps them.
  void keep_law(SearchWorker<Dim>& worker) const {
    if (worker.origin().worker == first_worker) return;
    if (memory.working() > much_memory) worker.free_arrays();
  }

  /// Arrays of a worker for parts that it searches by itself.
  [[nodiscard]] Workspace& for_part(std::size_t worker) {
    return of_parts.of(worker - first_worker, worker);
  }

  /// The parts that wait until a search in these arrays has ended.
  [[nodiscard]] WaitingParts<Dim>& waiting_parts() {
    if (!waiting) waiting = std::make_unique<WaitingParts<Dim>>(memory);
    return *waiting;
  }

  base::MemoryMeter& memory;
  std::size_t first_worker;
  Tiles<Dim> tiles;  ///< of search sets that all workers search together
  SetScratch<Dim> sets;
  LayerRecords<Dim> layer_records;
  FarSpheres<Dim> far_spheres;
  CoarseElements<Dim> coarse;
  SizeLevels<Dim> size_levels;
  OccupancySample<Dim> occupancy;
  Clusters<Dim> clusters;
  PlaneRows<Dim> plane;
  LayerCrowds<Dim> layer_crowds;
  PartWorkspaces<Dim> of_parts;
  std::unique_ptr<WaitingParts<Dim>> waiting;
  std::vector<std::unique_ptr<SearchWorker<Dim>>> workers;
  std::uint64_t much_memory = 0;  ///< more than this is in use only for a while
  LastSearch last;
  bool had_many_undecided = false;  ///< the last search in layers, as on lattices
};

}  // namespace abut::engine
