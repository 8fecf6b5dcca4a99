#pragma once

#include "base/array.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The size of a sample: a full one tells a mean occupancy of 1 to a fifth, a small one, which
/// costs a quarter, one of 16.
enum class SampleSize { small, full };

/// Cells of one size over a box with any number of them.
template <int Dim>
class ReachCells {
 public:
  /// Cells no narrower than 2^-60 of the box.
  ReachCells(const grid::Bounds<Dim>& box, double cell) : lower_(box.lower), cell_(cell) {}

  /// Number of the cell of a sphere. Others may have the same one, but hardly ever have.
  [[nodiscard]] std::uint64_t cell(const exact::Sphere<Dim>& sphere) const noexcept {
    constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15U;  // times 2^64, odd
    std::uint64_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double along = (sphere.center[axis] - lower_[axis]) / cell_;
      cell = cell * golden_ratio + static_cast<std::uint64_t>(along);
    }
    return cell;
  }

 private:
  std::array<double, Dim> lower_;
  double cell_;
};

/// Estimates how crowded cells are from some elements drawn at random, which are the same each
/// time.
class OccupancySample {
 public:
  explicit OccupancySample(base::MemoryMeter& memory);

  /// The mean occupancy of the elements' cells, sum of n^2 / N over cells of n elements: the chance
  /// that two elements drawn share a cell, times N. Elements that are spread at random, one for a
  /// cell, have 2.
  template <int Dim, class Cells>
  [[nodiscard]] double mean_occupancy(const Cells& cells, const LayerSpheres<Dim>& spheres,
                                      SampleSize size);

 private:
  [[nodiscard]] std::uint64_t pairs_in_a_cell(std::size_t draws);

  base::Array<std::uint64_t> drawn_;   ///< cells of the elements drawn
  base::Array<std::uint64_t> cells_;   ///< hash table: a cell in each slot that is taken
  base::Array<std::uint32_t> counts_;  ///< of elements in it; 0 where the slot is free
};

}  // namespace abut::engine
