#pragma once

#include "base/array.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

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

/// Elements of a search set drawn at random, the same each time, by which one estimates how crowded
/// cells are. They are drawn once, however many kinds of cells they are asked about: they lie
/// anywhere in memory, and to fetch them takes longer than all else.
template <int Dim>
class OccupancySample {
 public:
  explicit OccupancySample(base::MemoryMeter& memory);

  /// Takes its elements from those of `spheres` that stand in layers. They stay as they are for as
  /// long as it is asked.
  void take_from(const LayerSpheres<Dim>& spheres, std::size_t workers);

  /// The number of elements from which it takes.
  [[nodiscard]] std::size_t elements() const noexcept { return spheres_->count_in_layers(); }

  /// The mean occupancy of the elements' cells, sum of n^2 / N over cells of n elements: the chance
  /// that two elements drawn share a cell, times N. Elements that are spread at random, one for a
  /// cell, have 2.
  template <class Cells>
  [[nodiscard]] double mean_occupancy(const Cells& cells, SampleSize size);

  /// How unevenly elements are spread along an axis, where most so: the range of nine tenths of
  /// them to that of one half. Even ones have 1.8, those at all scales from a point 10 and more.
  /// From a small sample.
  [[nodiscard]] double unevenness();

 private:
  /// A slot of a hash table.
  struct CellSlot {
    std::uint32_t lower_bits;  ///< of the cell, scattered
    std::uint32_t elements;    ///< in the cell; 0 where the slot is free
  };

  void draw(std::size_t draws);

  std::optional<LayerSpheres<Dim>> spheres_;
  std::size_t workers_ = 1;
  std::size_t draws_ = 0;                       ///< so far, of these spheres
  base::Array<std::array<double, Dim>> drawn_;  ///< centers
  base::Array<CellSlot> slots_;
  base::Array<double> along_axis_;
};

}  // namespace abut::engine
