#pragma once

#include "base/memory_meter.hpp"
#include "engine/clusters/clusters.hpp"
#include "engine/crowds/layer_crowds.hpp"
#include "engine/crowds/part_scratch.hpp"
#include "engine/crowds/waiting_parts.hpp"
#include "engine/layers/coarse_elements.hpp"
#include "engine/layers/far_spheres.hpp"
#include "engine/layers/layer_records.hpp"
#include "engine/layers/occupancy_sample.hpp"
#include "engine/layers/size_levels.hpp"
#include "engine/tile_searcher.hpp"
#include "engine/worker_scratch.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace abut::engine {

/// All arrays of the engine. Kept from one detection to the next, it makes the next one free of
/// allocations.
template <int Dim>
struct Workspace {
  /// The first of its workers has this number: that of the worker for which it is made, if it is
  /// not for all.
  explicit Workspace(base::MemoryMeter& meter, std::size_t first = 0)
      : memory(meter),
        first_worker(first),
        levels(meter),
        layer_records(meter),
        far_spheres(meter),
        coarse(meter),
        size_levels(meter),
        occupancy(meter),
        clusters(meter),
        layer_crowds(meter),
        part_scratches(meter) {}

  void expect_workers(std::size_t count) {
    while (workers.size() < count) {
      workers.push_back(std::make_unique<TileSearcher<Dim>>(memory, first_worker + workers.size()));
    }
    part_scratches.expect_workers(count);
  }

  /// What a worker needs for a part that it searches by itself.
  [[nodiscard]] PartScratch<Dim>& part_scratch(std::size_t worker) {
    return part_scratches.of(worker - first_worker, worker);
  }

  /// The parts that wait, of the search of a whole set.
  [[nodiscard]] WaitingParts<Dim>& waiting_parts() {
    if (!waiting) waiting = std::make_unique<WaitingParts<Dim>>(memory);
    return *waiting;
  }
  /// The arrays for their search.
  [[nodiscard]] Workspace& for_waiting() {
    if (!of_waiting) of_waiting = std::make_unique<Workspace>(memory);
    return *of_waiting;
  }

  base::MemoryMeter& memory;
  std::size_t first_worker;
  RecursionLevels<Dim> levels;  ///< for search sets that all workers search together
  LayerRecords<Dim> layer_records;
  FarSpheres<Dim> far_spheres;
  CoarseElements<Dim> coarse;
  SizeLevels<Dim> size_levels;
  OccupancySample<Dim> occupancy;
  Clusters<Dim> clusters;
  LayerCrowds<Dim> layer_crowds;
  PartScratches<Dim> part_scratches;
  std::unique_ptr<WaitingParts<Dim>> waiting;
  std::unique_ptr<Workspace> of_waiting;
  std::vector<std::unique_ptr<TileSearcher<Dim>>> workers;
  RadiusHistogram histogram;
  std::size_t most_in_layers = 0;  ///< in the last search, elements of the largest set in layers
  std::size_t clusters_moved = 0;  ///< in the last search; 0 where elements stayed in their places
  std::size_t beside_layers = 0;  ///< in the last search, coarse elements without which it was done
  std::size_t levels_of_sizes = 0;  ///< in the last search; 0 where there were none
  bool had_many_undecided = false;  ///< the last search in layers, as on lattices
  std::vector<std::unique_ptr<Members>>
      deferred;  ///< large search sets that wait until all are free
};

}  // namespace abut::engine
