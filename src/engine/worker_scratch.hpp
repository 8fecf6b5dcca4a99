#pragma once

#include "base/array.hpp"
#include "engine/cross_level_runs.hpp"
#include "engine/layers/far_spheres.hpp"
#include "engine/layers/sorted_layers.hpp"
#include "engine/radius_histogram.hpp"
#include "engine/search_set.hpp"
#include "engine/sorted_tile.hpp"
#include "engine/tiles.hpp"
#include "exact/sphere.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut::engine {

/// Lists of the members of a search set that has its own.
struct Members {
  base::Array<std::uint32_t> locals;
  base::Array<std::uint32_t> halo;
  base::Array<std::uint32_t> coarse_elements;

  explicit Members(base::MemoryMeter& memory)
      : locals(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        halo(locals),
        coarse_elements(locals) {}

  void clear() noexcept {
    locals.clear();
    halo.clear();
    coarse_elements.clear();
  }

  [[nodiscard]] bool empty() const noexcept { return locals.empty(); }

  static Numbers numbers(const base::Array<std::uint32_t>& list) {
    return {list.data(), list.size()};
  }
};

/// Arrays of one depth of the recursion from search set to search set.
template <int Dim>
struct RecursionLevel {
  explicit RecursionLevel(base::MemoryMeter& memory)
      : tiles(memory), large(memory), small(memory), across(memory), part(memory) {}

  Tiles<Dim> tiles;
  Members large;  ///< after a division by size
  Members small;
  Members across;
  Members part;  ///< of a crowded tile
};

/// The levels that one line of recursion needs; they stay for the next detection.
template <int Dim>
class RecursionLevels {
 public:
  explicit RecursionLevels(base::MemoryMeter& memory) : memory_(memory) {}

  [[nodiscard]] RecursionLevel<Dim>& at(std::size_t depth) {
    while (levels_.size() <= depth)
      levels_.push_back(std::make_unique<RecursionLevel<Dim>>(memory_));
    return *levels_[depth];
  }

 private:
  base::MemoryMeter& memory_;
  std::vector<std::unique_ptr<RecursionLevel<Dim>>> levels_;
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
        levels(memory) {}

  SortedTile<Dim> tile;
  CrossLevelRuns<Dim> cross_level;
  base::Array<float> block;  ///< scratch of the kernels
  base::Array<std::uint32_t> block_number;
  SortedLayers<Dim> layers;
  FarSpheresInReach<Dim> far;
  RecursionLevels<Dim> levels;
  RadiusHistogram histogram;
};

}  // namespace abut::engine
