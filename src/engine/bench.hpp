#pragma once

#include "base/array.hpp"
#include "engine/group.hpp"
#include "engine/radius_histogram.hpp"
#include "engine/sorted_tile.hpp"
#include "engine/tiles.hpp"
#include "engine/visits.hpp"
#include "exact/sphere.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace abut::engine {

/// Lists of the members of a group that has its own.
struct Members {
  base::Array<std::uint32_t> natives;
  base::Array<std::uint32_t> foreigns;
  base::Array<std::uint32_t> visitors;

  explicit Members(base::MemoryMeter& memory)
      : natives(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        foreigns(natives),
        visitors(natives) {}

  void clear() noexcept {
    natives.clear();
    foreigns.clear();
    visitors.clear();
  }

  [[nodiscard]] bool empty() const noexcept { return natives.empty(); }

  static Numbers numbers(const base::Array<std::uint32_t>& list) {
    return {list.data(), list.size()};
  }
};

/// Arrays of one depth of the recursion from group to group.
template <int Dim>
struct Floor {
  explicit Floor(base::MemoryMeter& memory)
      : tiles(memory), large(memory), small(memory), across(memory), part(memory) {}

  Tiles<Dim> tiles;
  Members large;  ///< after a division by size
  Members small;
  Members across;
  Members part;  ///< of a crowded tile
};

/// The floors that one line of recursion needs; they stay for the next detection.
template <int Dim>
class Floors {
 public:
  explicit Floors(base::MemoryMeter& memory) : memory_(memory) {}

  [[nodiscard]] Floor<Dim>& at(std::size_t depth) {
    while (floors_.size() <= depth) floors_.push_back(std::make_unique<Floor<Dim>>(memory_));
    return *floors_[depth];
  }

 private:
  base::MemoryMeter& memory_;
  std::vector<std::unique_ptr<Floor<Dim>>> floors_;
};

/// What one worker needs to search a tile.
template <int Dim>
struct Bench {
  explicit Bench(base::MemoryMeter& memory)
      : tile(memory),
        visits(memory),
        block(base::make_array_for_overwrite<float>(memory, 0)),
        block_number(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        floors(memory) {}

  SortedTile<Dim> tile;
  Visits<Dim> visits;
  base::Array<float> block;  ///< scratch of the kernels
  base::Array<std::uint32_t> block_number;
  Floors<Dim> floors;
  RadiusHistogram histogram;
};

}  // namespace abut::engine
