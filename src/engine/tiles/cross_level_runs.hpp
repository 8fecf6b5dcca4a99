#pragma once

#include "base/array.hpp"
#include "engine/tiles/tile_grid.hpp"
#include "exact/elements.hpp"
#include "kernels/tiles/tile_view.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace abut::engine {

/// Place and cell size of a tile, by which coarse elements are mapped into it.
template <int Dim>
struct TileFrame {
  const TileGrid<Dim>& grid;
  std::array<double, Dim> tile{};       ///< its coordinates, along the axes
  std::array<double, Dim> cell_size{};  ///< in the tile's unit
  double unit = 1.0;
  double largest_radius = 0.0;  ///< of the tile's own, in its unit
  double margin = 0.0;          ///< in its unit

  /// Position along an axis in the tile's unit.
  [[nodiscard]] double position(double x, std::size_t axis) const noexcept {
    return grid.within(x, tile[axis], axis) * (grid.size[axis] * unit);
  }
};

/// The runs of a tile's own elements that a coarse element may reach, one for each row of cells.
template <int Dim>
class CrossLevelRuns {
 public:
  explicit CrossLevelRuns(base::MemoryMeter& memory);

  /// The runs are valid until the next call.
  [[nodiscard]] std::span<const kernels::Run> runs(const kernels::TileView& tile,
                                                   const TileFrame<Dim>& frame,
                                                   const exact::Elements<Dim>& elements,
                                                   std::uint32_t coarse);

  /// Rows of cells that were looked at for the last runs.
  [[nodiscard]] std::size_t rows() const noexcept { return rows_; }

 private:
  base::Array<kernels::Run> runs_;
  std::size_t rows_ = 0;
};

/// The coarse element in the tile's coordinates, with the error of its distances; none where it is
/// a sphere so large or so far that single precision says nothing.
template <int Dim>
[[nodiscard]] std::optional<kernels::CoarseElement> coarse_element_in(
    const TileFrame<Dim>& frame, const exact::Elements<Dim>& elements, std::uint32_t number);

}  // namespace abut::engine
