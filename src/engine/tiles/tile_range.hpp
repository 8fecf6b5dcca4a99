#pragma once

#include "engine/query_box.hpp"
#include "engine/tiles/tile_grid.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The tiles that a coarse element may reach.
template <int Dim>
class TileRange {
 public:
  TileRange(const TileGrid<Dim>& grid, const QueryBox<Dim>& query_box)
      : grid_(grid), inverse_reach_(query_box.inverse_radius) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      center_[axis] = query_box.center[axis] - grid.lower[axis];
      first_[axis] = tile_at(query_box.lower[axis], -slack, axis);
      last_[axis] = tile_at(query_box.upper[axis], slack, axis);
      reaches_box_ =
          reaches_box_ && query_box.upper[axis] - grid.lower[axis] >= -grid.size[axis] &&
          query_box.lower[axis] - grid.lower[axis] <= grid.size[axis] * (grid.count[axis] + 1);
    }
  }

  template <class Body>
  void for_each(Body&& body) const {
    if (!reaches_box_) return;
    const std::int32_t first_z = Dim == 3 ? first_[Dim - 1] : 0;
    const std::int32_t last_z = Dim == 3 ? last_[Dim - 1] : 0;
    for (std::int32_t z = first_z; z <= last_z; ++z) {
      for (std::int32_t y = first_[1]; y <= last_[1]; ++y) {
        for (std::int32_t x = first_[0]; x <= last_[0]; ++x) {
          if (!reaches({x, y, z})) continue;
          std::int32_t tile = (x + 1) * grid_.stride[0] + (y + 1) * grid_.stride[1];
          if constexpr (Dim == 3) tile += (z + 1) * grid_.stride[2];
          body(static_cast<std::size_t>(tile));
        }
      }
    }
  }

 private:
  /// Roundings of a position in units of tiles, generously.
  static constexpr double slack = 0x1p-20;

  [[nodiscard]] std::int32_t tile_at(double x, double shift, std::size_t axis) const {
    const double q = (x - grid_.lower[axis]) * grid_.inverse_size[axis] + shift;
    return static_cast<std::int32_t>(
        std::clamp(q, 0.0, static_cast<double>(grid_.count[axis] - 1)));
  }

  /// Tells whether the ball, if there is one, reaches the tile, or nearly.
  [[nodiscard]] bool reaches(const std::array<std::int32_t, 3>& tile) const {
    double distance_squared = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double width = grid_.size[axis] * (1.0 + 2.0 * slack);
      const double below = (tile[axis] - slack) * grid_.size[axis] - center_[axis];
      const double outside = std::max({0.0, below, -below - width}) * inverse_reach_;
      distance_squared += outside * outside;
    }
    return distance_squared <= 1.0 + slack;
  }

  const TileGrid<Dim>& grid_;
  std::array<double, Dim> center_{};  ///< from the lower corner of the box
  double inverse_reach_;
  std::array<std::int32_t, Dim> first_{};
  std::array<std::int32_t, Dim> last_{};
  bool reaches_box_ = true;
};

}  // namespace abut::engine
