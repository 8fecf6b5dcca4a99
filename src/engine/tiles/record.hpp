#pragma once

#include "engine/tiles/tile_grid.hpp"
#include "exact/sphere.hpp"
#include "kernels/element_kernels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// An element as its tile sees it: single precision, from the tile's lower corner, in a unit (a
/// power of two) in which tile and cell are at most 1 wide. Good for a filter with a stated error;
/// the exact test reads the original. Radii, where they differ, stand in a column of their own.
template <int Dim>
struct Record {
  float center[Dim];
  std::uint32_t number;
};

/// Turns elements into records of a tile.
template <int Dim>
class Recorder {
 public:
  explicit Recorder(const TileGrid<Dim>& grid) : grid_(grid), unit_(unit_of(grid)) {
    for (std::size_t axis = 0; axis < Dim; ++axis) size_[axis] = grid.size[axis] * unit_;
  }

  /// Lengths times this are lengths in a tile.
  [[nodiscard]] double unit() const noexcept { return unit_; }

  [[nodiscard]] float length(double length) const noexcept {
    return static_cast<float>(length * unit_);
  }

  [[nodiscard]] Record<Dim> record(const exact::Sphere<Dim>& sphere, std::uint32_t number,
                                   const std::array<double, Dim>& tile) const noexcept {
    Record<Dim> record;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      record.center[axis] =
          static_cast<float>(grid_.within(sphere.center[axis], tile[axis], axis) * size_[axis]);
    }
    record.number = number;
    return record;
  }

  /// Returns the record of a halo element. One beyond the upper end of the box is put beyond the
  /// last tile, which may be slightly wider than a flat box.
  [[nodiscard]] Record<Dim> record_of_halo(const exact::Sphere<Dim>& sphere, std::uint32_t number,
                                           const std::array<double, Dim>& tile,
                                           const grid::Bounds<Dim>& box) const noexcept {
    Record<Dim> result = record(sphere, number, tile);
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      if (sphere.center[axis] <= box.upper[axis]) continue;
      result.center[axis] = std::max(result.center[axis], static_cast<float>(size_[axis]));
    }
    return result;
  }

  /// Returns the map from locals to records in their own tiles, as the vector kernels take it.
  [[nodiscard]] kernels::RecordMap map() const noexcept {
    kernels::RecordMap map{grid_.place_map(), {}};
    std::copy(size_.begin(), size_.end(), map.scale);
    return map;
  }

 private:
  /// A power of two that makes the widest side of a tile, or a cell, at most 1.
  static double unit_of(const TileGrid<Dim>& grid) noexcept {
    const double widest =
        std::max(grid.cell_size, *std::max_element(grid.size.begin(), grid.size.end()));
    return std::ldexp(1.0, -(std::ilogb(widest) + 1));
  }

  const TileGrid<Dim>& grid_;
  double unit_;
  std::array<double, Dim> size_{};
};

}  // namespace abut::engine
