#pragma once

#include "base/array.hpp"
#include "engine/layers/layer_grid.hpp"
#include "kernels/sphere_parts.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The size of a sample: a full one tells a mean occupancy of 1 to a fifth, a small one, which
/// costs a quarter, one of 16.
enum class SampleSize { small, full };

/// Estimates how crowded cells are from some elements drawn at random, which are the same each
/// time.
class OccupancySample {
 public:
  explicit OccupancySample(base::MemoryMeter& memory);

  /// The mean occupancy of the elements' cells, sum of n^2 / N over cells of n elements: the chance
  /// that two elements drawn share a cell, times N. Elements that are spread at random, one for a
  /// cell, have 2.
  template <int Dim>
  [[nodiscard]] double mean_occupancy(const LayerGrid<Dim>& grid,
                                      const kernels::SphereParts& spheres, SampleSize size);

 private:
  [[nodiscard]] std::uint64_t pairs_in_a_cell(std::size_t draws);

  base::Array<std::uint64_t> drawn_;   ///< cells of the elements drawn
  base::Array<std::uint64_t> cells_;   ///< hash table: a cell in each slot that is taken
  base::Array<std::uint32_t> counts_;  ///< of elements in it; 0 where the slot is free
};

}  // namespace abut::engine
