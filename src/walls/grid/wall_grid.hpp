#pragma once

#include "base/array.hpp"
#include "base/memory_meter.hpp"
#include "base/progress_reporter.hpp"
#include "exact/box.hpp"
#include "kernels/walls/wall_kernels.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace abut::walls {

/// A grid that knows, for each cell, the parts of a wall near it: a part is named by all cells that
/// the box around it meets when it is made wider by `reach` on every side. So a point has each part
/// within reach among those of its cell. It keeps its memory.
///
/// Nothing depends on rounding: the place of a point along an axis is one function that never
/// decreases, for points and for the ends of boxes.
class WallGrid {
 public:
  explicit WallGrid(base::MemoryMeter& memory);

  /// Builds the grid of `count` parts with finite boxes; `box_of(k)` is the one of part k.
  template <class BoxOf>
  void build(std::size_t count, double reach, base::WorkCounter& work, BoxOf&& box_of);

  /// What stands for a cell that no part is near.
  static constexpr std::size_t no_place = std::numeric_limits<std::size_t>::max();

  /// Returns the place of a point's cell among those that parts are near, or no_place.
  [[nodiscard]] std::size_t place_near(const double (&point)[3]) const noexcept {
    // What lies before the first cell by less than a cell is looked for in it, at no harm. Numbers
    // that no integer holds, and those that are none, become one that no cell has.
    const std::uint32_t x = whole_part(place_of(point[0], 0));
    const std::uint32_t y = whole_part(place_of(point[1], 1));
    const std::uint32_t z = whole_part(place_of(point[2], 2));
    if (!((x < size_[0]) & (y < size_[1]) & (z < size_[2]))) return no_place;
    const std::size_t cell = (std::size_t{z} * size_[1] + y) * size_[0] + x;
    if ((occupied_[cell / 32] >> (cell % 32) & 1) == 0) return no_place;
    return place_of_cell(cell);
  }

  /// Cells that parts are near.
  [[nodiscard]] std::size_t places() const noexcept { return begin_.size() - 2; }

  /// Parts that may be within reach of a point of the cell with that place, ascending; never none.
  [[nodiscard]] std::span<const ElementIndex> parts(std::size_t place) const noexcept {
    return std::span<const ElementIndex>(parts_).subspan(begin_[place],
                                                         begin_[place + 1] - begin_[place]);
  }

  /// Says where points are looked for. Returns false where there are too many cells for kernels.
  [[nodiscard]] bool describe(kernels::WallJob& job) const noexcept;

 private:
  /// Cells from the first to the last along each axis.
  struct CellRange {
    std::size_t first[3];
    std::size_t last[3];

    [[nodiscard]] std::uint64_t size() const noexcept {
      return (last[0] - first[0] + 1) * (last[1] - first[1] + 1) * (last[2] - first[2] + 1);
    }
  };

  /// Wider by `reach` and by more than rounding takes away.
  [[nodiscard]] static exact::Box<3> wider(const exact::Box<3>& box, double reach) noexcept;
  [[nodiscard]] static std::uint64_t most_entries(std::size_t count) noexcept;
  [[nodiscard]] double shortest_cell(std::size_t count, double reach) const noexcept;
  void lay_cells(double length) noexcept;
  [[nodiscard]] CellRange cells_near(const exact::Box<3>& box) const noexcept;
  void number_places();
  void add_up();

  [[nodiscard]] std::size_t cell_count() const noexcept { return size_[0] * size_[1] * size_[2]; }
  /// Of a cell whose bit is set.
  [[nodiscard]] std::size_t place_of_cell(std::size_t cell) const noexcept {
    const std::uint32_t before = (std::uint32_t{1} << (cell % 32)) - 1;
    return places_before_[cell / 32] +
           static_cast<std::size_t>(std::popcount(occupied_[cell / 32] & before));
  }
  [[nodiscard]] double place_of(double x, int axis) const noexcept {
    return (x - origin_[axis]) * inverse_[axis];
  }
  [[nodiscard]] static std::uint32_t whole_part(double place) noexcept {
    constexpr double most = 0x1p31;
    if (!(place > -1.0 && place < most)) return 0xFFFFFFFF;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(place));
  }
  /// Calls act(cell) for each cell of a range.
  template <class Act>
  void for_each_cell(const CellRange& range, base::WorkCounter& work, Act&& act) const {
    for (std::size_t z = range.first[2]; z <= range.last[2]; ++z) {
      for (std::size_t y = range.first[1]; y <= range.last[1]; ++y) {
        const std::size_t row = (z * size_[1] + y) * size_[0];
        for (std::size_t x = range.first[0]; x <= range.last[0]; ++x) act(row + x);
        work.did(range.last[0] - range.first[0] + 1);
      }
    }
  }

  exact::Box<3> around_{};  ///< all that is within reach of a part
  double origin_[3] = {};
  double inverse_[3] = {};  ///< of the length of a cell
  std::size_t size_[3] = {};
  base::Array<std::uint32_t> occupied_;       ///< a bit for each cell
  base::Array<std::uint64_t> places_before_;  ///< the bits that are set in the words before each
  base::Array<std::uint64_t> begin_;          ///< first of the parts of each cell that has some
  base::Array<ElementIndex> parts_;
};

template <class BoxOf>
void WallGrid::build(std::size_t count, double reach, base::WorkCounter& work, BoxOf&& box_of) {
  exact::Box<3> around = count > 0 ? box_of(0) : exact::Box<3>{};
  for (std::size_t k = 1; k < count; ++k) {
    const exact::Box<3> box = box_of(k);
    for (int axis = 0; axis < 3; ++axis) {
      around.lower[axis] = std::min(around.lower[axis], box.lower[axis]);
      around.upper[axis] = std::max(around.upper[axis], box.upper[axis]);
    }
  }
  around_ = wider(around, reach);
  for (double length = shortest_cell(count, reach);; length *= 1.5) {
    lay_cells(length);
    std::uint64_t entries = 0;
    for (std::size_t k = 0; k < count; ++k) entries += cells_near(wider(box_of(k), reach)).size();
    work.did(4 * count);
    if (cell_count() == 1 || entries <= most_entries(count)) break;
  }
  const auto for_each_entry = [&](auto&& act) {
    for (std::size_t k = 0; k < count; ++k) {
      for_each_cell(cells_near(wider(box_of(k), reach)), work,
                    [&](std::size_t cell) { act(cell, k); });
    }
  };
  occupied_.assign(cell_count() / 32 + 1, 0);
  for_each_entry([&](std::size_t cell, std::size_t) {
    occupied_[cell / 32] |= std::uint32_t{1} << (cell % 32);
  });
  number_places();
  for_each_entry([&](std::size_t cell, std::size_t) { ++begin_[place_of_cell(cell) + 2]; });
  add_up();
  for_each_entry([&](std::size_t cell, std::size_t k) {
    parts_[begin_[place_of_cell(cell) + 1]++] = static_cast<ElementIndex>(k);
  });
}

}  // namespace abut::walls
