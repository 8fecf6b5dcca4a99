#pragma once

#include "base/memory_meter.hpp"
#include "engine/clusters/clusters.hpp"
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
  explicit Workspace(base::MemoryMeter& meter)
      : memory(meter),
        levels(meter),
        layer_records(meter),
        far_spheres(meter),
        coarse(meter),
        size_levels(meter),
        occupancy(meter),
        clusters(meter) {}

  void expect_workers(std::size_t count) {
    while (workers.size() < count) {
      workers.push_back(std::make_unique<TileSearcher<Dim>>(memory, workers.size()));
    }
  }

  base::MemoryMeter& memory;
  RecursionLevels<Dim> levels;  ///< for search sets that all workers search together
  LayerRecords<Dim> layer_records;
  FarSpheres<Dim> far_spheres;
  CoarseElements<Dim> coarse;
  SizeLevels<Dim> size_levels;
  OccupancySample<Dim> occupancy;
  Clusters<Dim> clusters;
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
