#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/layers/layer_grid.hpp"
#include "engine/layers/layer_records.hpp"
#include "kernels/layers/layer_kernels.hpp"
#include "kernels/strided_spheres.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Adjacent layers sorted by row and column, which take turns: while one is searched with its
/// neighbors, the next one replaces the one that is not needed any more. They stand in the same
/// columns, each in a part of its own: two, or three of elements that look for smaller ones
/// (kernels::LayerPair, kernels::ThreeLayers). Kept from search to search.
template <int Dim>
class SortedLayers {
 public:
  explicit SortedLayers(base::MemoryMeter& memory);

  /// Integers of 4 bytes for layers of at most so many elements, copies of their spheres included.
  [[nodiscard]] std::size_t integers_for(const LayerGrid<Dim>& grid,
                                         std::size_t largest_layer) noexcept;

  /// Makes room for layers of at most so many elements.
  void start(const LayerGrid<Dim>& grid, std::size_t largest_layer);

  /// Sorts the records of layer k, by counting, into its part, with copies of their spheres unless
  /// `spheres` is null: of those of the layer, if there are any, or of all.
  void sort(const LayerGrid<Dim>& grid, std::size_t k, const LayerElements<Dim>& elements,
            const kernels::StridedSpheres* spheres, const kernels::LayerKernels& kernels,
            base::WorkCounter& work);

  /// Layer k and the one above it, both of which must have been sorted.
  [[nodiscard]] kernels::LayerPair pair(const LayerGrid<Dim>& grid, std::size_t k) const noexcept;

  /// Layer k, the one below and the one above it, all of which must have been sorted: `before(k)`
  /// and k + 1 besides.
  [[nodiscard]] kernels::ThreeLayers three_layers(const LayerGrid<Dim>& grid,
                                                  std::size_t k) const noexcept;

  /// Layer k by itself, as coarse elements meet it.
  [[nodiscard]] kernels::ThreeLayers layer_alone(const LayerGrid<Dim>& grid,
                                                 std::size_t k) const noexcept;

  /// The layer below k. Layer 0 has one that holds nothing.
  [[nodiscard]] std::size_t before(std::size_t k) const noexcept { return k + parts_ - 1; }

 private:
  void count(const LayerGrid<Dim>& grid, std::uint32_t* table,
             std::span<const kernels::PositionRecord> records, const kernels::LayerKernels& kernels,
             base::WorkCounter& work);
  void lay_out(const LayerGrid<Dim>& grid, std::size_t largest_layer) noexcept;
  [[nodiscard]] std::uint32_t lay_out_table(const LayerGrid<Dim>& grid, std::uint32_t* table,
                                            std::uint32_t begin,
                                            const kernels::LayerKernels& kernels) const noexcept;
  void place(const LayerElements<Dim>& elements, std::uint32_t* table, std::uint32_t begin,
             base::WorkCounter& work);
  void copy(const kernels::StridedSpheres& spheres, std::uint32_t begin, std::size_t size,
            base::WorkCounter& work);
  void pad(const LayerGrid<Dim>& grid, const std::uint32_t* table, kernels::PositionRecord* placed,
           std::uint32_t end) noexcept;

  [[nodiscard]] std::uint32_t* table(std::size_t k) noexcept {
    return tables_.data() + k % parts_ * table_size_;
  }
  [[nodiscard]] const std::uint32_t* table(std::size_t k) const noexcept {
    return tables_.data() + k % parts_ * table_size_;
  }

  [[nodiscard]] float* widths(std::size_t axis) noexcept { return widths_.data() + axis * length_; }

  base::Array<std::uint32_t> tables_;
  base::Array<std::uint32_t> entry_of_;  ///< of the records being sorted, in the table
  base::Array<kernels::PositionRecord> placed_;
  base::Array<std::int32_t> positions_;  ///< by axis
  base::Array<std::uint32_t> numbers_;
  base::Array<std::uint32_t> columns_;
  base::Array<float> radii_;
  base::Array<float> widths_;  ///< of boxes, by axis
  base::Array<exact::Sphere<Dim>> copies_;
  std::array<bool, 2> has_copies_{};  ///< of two layers
  std::size_t parts_ = 2;
  std::size_t part_ = 0;    ///< places of a layer
  std::size_t length_ = 0;  ///< of a column
  std::size_t table_size_ = 0;
  std::size_t row_length_ = 0;
};

}  // namespace abut::engine
