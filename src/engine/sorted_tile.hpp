#pragma once

#include "base/array.hpp"
#include "engine/tile_cells.hpp"
#include "engine/tiles.hpp"
#include "kernels/tile_view.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// One tile sorted by cell: contiguous arrays for the kernels, kept from tile to tile. The layout
/// is that of kernels::TileView.
template <int Dim>
class SortedTile {
 public:
  explicit SortedTile(base::MemoryMeter& memory);

  /// First half of the counting sort. The first `own` records are the tile's own.
  void count(std::span<const Record<Dim>> records, std::size_t own, const TileCells<Dim>& cells);

  /// Sum of the squared numbers of elements in each cell: how crowded they are.
  [[nodiscard]] std::uint64_t crowding() const noexcept { return crowding_; }

  /// Second half, of the same records. `common_radius` >= 0 if all radii are equal to it.
  void sort(std::span<const Record<Dim>> records, float common_radius);

  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  [[nodiscard]] const kernels::TileView& view() const noexcept { return view_; }

 private:
  void make_room_for(std::size_t elements, std::size_t cells);
  void sum_up(std::size_t cell_total);

  base::Array<float> numbers_;  ///< centers by axis, then radii
  base::Array<std::uint32_t> names_;
  base::Array<std::uint32_t> cell_of_;
  base::Array<std::uint32_t> cell_begin_;
  std::uint64_t crowding_ = 0;
  std::size_t size_ = 0;
  kernels::TileView view_{};
};

}  // namespace abut::engine
