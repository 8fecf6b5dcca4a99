#pragma once

#include "base/array.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::grid {

/// A stretch of an axis without a gap wider than a cell, and the number of its first cell.
struct Segment {
  double start;  ///< coordinate of the lowest element, scaled
  std::int32_t first_cell;
};

/// The map from a coordinate to a cell number on one axis, for all algorithms of the book. Tiles
/// have one of their own (engine/tiles/tile_grid.hpp).
///
///   cell(x) = first_cell + floor((x * scale - start) / cell_size)
///
/// An axis of at most 2^30 cells is one segment. On a longer one each gap wider than a cell is
/// collapsed: every cluster is a segment of its own, and its cells follow those of the cluster
/// before it, with one empty cell between them, so that numbers never exceed twice the number of
/// elements. Nothing across such a gap can be within reach.
class AxisMap {
 public:
  AxisMap(double scale, double cell_size, base::Array<Segment> segments)
      : scale_(scale),
        inverse_cell_size_(1.0 / cell_size),
        first_start_(segments.front().start),
        segments_(std::move(segments)) {}

  [[nodiscard]] std::int32_t cell(double x) const noexcept {
    const double scaled = x * scale_;
    if (segments_.size() == 1) return cells_between(first_start_, scaled);
    const Segment segment = segment_of(scaled);
    return segment.first_cell + cells_between(segment.start, scaled);
  }

 private:
  /// Returns how many whole cells lie between. No element lies before its segment, so that
  /// truncation is floor.
  [[nodiscard]] std::int32_t cells_between(double start, double scaled) const noexcept {
    return static_cast<std::int32_t>((scaled - start) * inverse_cell_size_);
  }

  [[nodiscard]] Segment segment_of(double scaled) const noexcept {
    const auto behind =
        std::upper_bound(segments_.begin() + 1, segments_.end(), scaled,
                         [](double value, const Segment& s) { return value < s.start; });
    return *(behind - 1);
  }

  double scale_;
  double inverse_cell_size_;
  double first_start_;
  base::Array<Segment> segments_;
};

}  // namespace abut::grid
