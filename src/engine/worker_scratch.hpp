#pragma once

#include "base/array.hpp"
#include "engine/layers/far_spheres.hpp"
#include "engine/layers/sorted_layers.hpp"
#include "engine/sizes/radius_histogram.hpp"
#include "engine/tiles/cross_level_runs.hpp"
#include "engine/tiles/sorted_tile.hpp"
#include "engine/tiles/tiles.hpp"
#include "engine/waiting_sets.hpp"
#include "exact/sphere.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// What comes of a search set, and a look at its sizes; it stays for the next detection.
template <int Dim>
struct SetScratch {
  explicit SetScratch(base::MemoryMeter& memory) : waiting(memory) {}

  WaitingSets<Dim> waiting;
  RadiusHistogram histogram;
};

/// Arrays that one worker needs to search a tile.
template <int Dim>
struct WorkerScratch {
  explicit WorkerScratch(base::MemoryMeter& memory)
      : tile(memory),
        cross_level(memory),
        block(base::make_array_for_overwrite<float>(memory, 0)),
        block_number(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        layers(memory),
        far(memory),
        tiles(memory),
        sets(memory) {}

  SortedTile<Dim> tile;
  CrossLevelRuns<Dim> cross_level;
  base::Array<float> block;  ///< scratch of the kernels
  base::Array<std::uint32_t> block_number;
  SortedLayers<Dim> layers;
  FarSpheresInReach<Dim> far;
  Tiles<Dim> tiles;  ///< of search sets that the worker has for itself
  SetScratch<Dim> sets;
};

}  // namespace abut::engine
