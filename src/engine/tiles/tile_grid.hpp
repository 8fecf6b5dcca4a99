#pragma once

#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "kernels/element_kernels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Positions are known to a small part of this, in cells: those moved in a periodic domain are off
/// by up to 2^-24 (docs/derivations/tile_filter.md, section 3). CoarseElements are looked for so
/// much farther out.
inline constexpr double position_slack = 0x1p-20;

/// Cuts a box into equal tiles and says which tile an element belongs to and which others must see
/// a copy of it.
///
///   tile number = (t_z + 1) * stride_z + (t_y + 1) * stride_y + (t_x + 1)
///
/// with one empty tile all around, where halo elements may lie. Of two or more tiles along an axis
/// none is narrower than a cell, so that only adjacent tiles are within reach of each other.
template <int Dim>
struct TileGrid {
  std::array<double, Dim> lower{};
  std::array<double, Dim> size{};  ///< side of a tile, > 0
  std::array<double, Dim> inverse_size{};
  std::array<double, Dim> border{};  ///< elements within this fraction of a face have copies
  std::array<std::int32_t, Dim> count{};
  std::array<std::int32_t, Dim> stride{};
  std::size_t tile_count = 0;  ///< the empty ones included
  double cell_size = 0.0;      ///< a hair above the largest reach

  /// At most `most_tiles` over the box, none narrower than `least_cells` >= 1 cells where an axis
  /// has more than one.
  [[nodiscard]] static TileGrid over(const grid::Bounds<Dim>& box, double cell_size,
                                     double least_cells, double most_tiles);

  /// So many along the longest axis of the box, which has as many cells at least.
  [[nodiscard]] static TileGrid slices_of(const grid::Bounds<Dim>& box, double cell_size,
                                          double slices);

  [[nodiscard]] double tiles_in_box() const noexcept {
    double tiles = 1.0;
    for (const std::int32_t along_axis : count) tiles *= along_axis;
    return tiles;
  }

  /// The number of the first tile of the box, behind the frame.
  [[nodiscard]] std::size_t first_tile() const noexcept {
    std::size_t tile = 0;
    for (const std::int32_t along_axis : stride) tile += static_cast<std::size_t>(along_axis);
    return tile;
  }

  struct TilePlace {
    std::uint32_t tile;
    std::uint32_t near_faces;  ///< bit 2 a: near the lower face of axis a; bit 2 a + 1: the upper
  };

  /// Returns the place of a local element, which lies in the box.
  [[nodiscard]] TilePlace place(const exact::Sphere<Dim>& sphere) const noexcept {
    std::int32_t tile = 0;
    std::uint32_t near_faces = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double q = (sphere.center[axis] - lower[axis]) * inverse_size[axis];
      const std::int32_t last = count[axis] - 1;
      std::int32_t t = static_cast<std::int32_t>(q);
      t = t > last ? last : t;
      tile += (t + 1) * stride[axis];
      near_faces |= near(q, t, axis);
    }
    return {static_cast<std::uint32_t>(tile), near_faces};
  }

  /// Returns the place of a halo element, which lies at most a cell outside the box on every axis,
  /// and outside on one. Tiles of the empty frame are those before the first and behind the last.
  [[nodiscard]] TilePlace place_of_halo(const exact::Sphere<Dim>& sphere,
                                        const grid::Bounds<Dim>& box) const noexcept {
    std::int32_t tile = 0;
    std::uint32_t near_faces = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double x = sphere.center[axis];
      const double q = (x - lower[axis]) * inverse_size[axis];
      std::int32_t t = count[axis];
      if (x < box.lower[axis]) {
        t = -1;
      } else if (x <= box.upper[axis]) {
        t = static_cast<std::int32_t>(q);
        t = t > count[axis] - 1 ? count[axis] - 1 : t;
      }
      tile += (t + 1) * stride[axis];
      // There is nothing beyond the frame.
      const std::uint32_t has_lower = t >= 0;
      const std::uint32_t has_upper = t < count[axis];
      near_faces |= near(q, t, axis) & (has_lower | has_upper << 1) << (2 * axis);
    }
    return {static_cast<std::uint32_t>(tile), near_faces};
  }

  /// Returns the map from elements to places in the form that the vector kernels take.
  [[nodiscard]] kernels::PlaceMap place_map() const noexcept;

  /// Position along an axis, in tiles from the lower face of tile t: by the same operations as the
  /// tile itself, so that both agree however far from 0 the box lies.
  [[nodiscard]] double within(double x, double t, std::size_t axis) const noexcept {
    return (x - lower[axis]) * inverse_size[axis] - t;
  }

  /// Numbers of a tile along the axes, whole numbers.
  [[nodiscard]] std::array<double, Dim> coordinates(std::size_t tile) const noexcept {
    std::array<double, Dim> result{};
    auto rest = static_cast<std::int32_t>(tile);
    for (std::size_t axis = Dim; axis-- > 0;) {
      result[axis] = static_cast<double>(rest / stride[axis] - 1);
      rest %= stride[axis];
    }
    return result;
  }

 private:
  [[nodiscard]] static TileGrid of_counts(const grid::Bounds<Dim>& box, double cell_size,
                                          const std::array<double, Dim>& tiles);

  /// Faces of tile t on the axis that lie within the border of position q, in units of tiles.
  [[nodiscard]] std::uint32_t near(double q, std::int32_t t, std::size_t axis) const noexcept {
    const double within = q - t;
    return static_cast<std::uint32_t>(within <= border[axis]) << (2 * axis) |
           static_cast<std::uint32_t>(within >= 1.0 - border[axis]) << (2 * axis + 1);
  }
};

}  // namespace abut::engine
