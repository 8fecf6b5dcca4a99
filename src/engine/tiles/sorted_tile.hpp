#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "engine/tiles/record.hpp"
#include "engine/tiles/tile_cells.hpp"
#include "kernels/element_kernels.hpp"
#include "kernels/tiles/tile_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Sizes of the records of a tile.
struct RecordSizes {
  kernels::ElementShape shape = kernels::ElementShape::equal_spheres;
  std::span<const float> sizes;  ///< record by record
  float common_radius = 0.0f;    ///< of equal spheres; of others the largest
};

/// One tile sorted by cell: contiguous arrays for the kernels, kept from tile to tile. The layout
/// is that of kernels::TileView.
template <int Dim>
class SortedTile {
 public:
  explicit SortedTile(base::MemoryMeter& memory);

  /// First half of the counting sort. The first `own` records are the tile's own.
  void count(std::span<const Record<Dim>> records, std::size_t own, const TileCells<Dim>& cells,
             const kernels::ElementKernels& kernels, base::WorkCounter& work);

  /// Sum of the squared numbers of elements in each cell: how crowded they are.
  [[nodiscard]] std::uint64_t squared_occupancy() const noexcept { return squared_occupancy_; }

  /// Second half, of the same records, with what says how large they are.
  void sort(std::span<const Record<Dim>> records, const RecordSizes& sizes,
            const kernels::ElementKernels& kernels, base::WorkCounter& work);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] const kernels::TileView& view() const noexcept { return view_; }

  /// Places in the rows that an element of the tile meets, at most.
  [[nodiscard]] std::size_t most_places_met() const noexcept;

 private:
  void make_room_for(std::size_t elements, std::size_t cells);

  void find_cells(std::span<const Record<Dim>> records, std::size_t own,
                  const TileCells<Dim>& cells, const kernels::ElementKernels& kernels,
                  base::WorkCounter& work);
  void arrange(std::span<const Record<Dim>> records, const kernels::ElementKernels& kernels,
               base::WorkCounter& work);
  void arrange_sizes(const RecordSizes& sizes, base::WorkCounter& work);

  [[nodiscard]] float* column(std::size_t k) noexcept {
    return numbers_.data() + k * (numbers_.size() / Dim);
  }
  [[nodiscard]] float* size_column(std::size_t k) noexcept {
    return sizes_.data() + k * (numbers_.size() / Dim);
  }
  /// Places of the elements of a row, without its padding.
  [[nodiscard]] kernels::Run row_places(std::size_t row) const noexcept {
    return {cell_begin_[row * row_length_], cell_begin_[(row + 1) * row_length_ - 1]};
  }

  base::Array<float> numbers_;  ///< centers by axis
  base::Array<float> sizes_;    ///< columns of the same length
  base::Array<std::uint32_t> names_;
  base::Array<std::uint32_t> order_;    ///< number of the record in each place
  base::Array<std::uint32_t> cells_;    ///< of the sorted elements
  base::Array<std::uint32_t> cell_of_;  ///< of the records
  base::Array<std::uint32_t> cell_begin_;
  std::uint64_t squared_occupancy_ = 0;
  std::size_t size_ = 0;
  std::size_t row_length_ = 1;
  std::size_t row_count_ = 0;
  kernels::TileView view_{};
};

}  // namespace abut::engine
