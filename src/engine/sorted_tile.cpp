#include "engine/sorted_tile.hpp"

#include <algorithm>
#include <limits>

namespace abut::engine {
namespace {

/// Cell of a position along one axis, counted from 0 where copies lie: 1 makes the argument
/// positive, so that truncation is the floor.
float framed(float center, float per_unit) {
  return center * per_unit + 1.0f;
}

template <int Dim>
class CellOf {
 public:
  explicit CellOf(const TileCells<Dim>& cells) : cells_(cells) {
    std::int32_t stride = 1;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      stride_[axis] = stride;
      stride *= cells.count[axis] + 2;
    }
    total_ = static_cast<std::size_t>(stride);
  }

  [[nodiscard]] std::size_t total() const { return total_; }

  [[nodiscard]] std::uint32_t own(const Record<Dim>& record) const {
    std::int32_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const auto last = static_cast<float>(cells_.count[axis]);
      const float q = framed(record.center[axis], cells_.per_unit[axis]);
      cell += static_cast<std::int32_t>(std::min(std::max(q, 1.0f), last)) * stride_[axis];
    }
    return static_cast<std::uint32_t>(cell);
  }

  /// A copy lies outside the tile, but the rounding of its position may hide that: then it goes to
  /// the frame that it is nearest to.
  [[nodiscard]] std::uint32_t copy(const Record<Dim>& record) const {
    std::int32_t cell = 0;
    float outermost = -std::numeric_limits<float>::max();
    std::int32_t step_outwards = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const auto frame = static_cast<float>(cells_.count[axis] + 1);
      const float q = framed(record.center[axis], cells_.per_unit[axis]);
      const auto index = static_cast<std::int32_t>(std::min(std::max(q, 0.0f), frame));
      cell += index * stride_[axis];
      const float beyond_upper = q - frame;
      const float beyond_lower = 1.0f - q;
      if (beyond_upper > outermost) {
        outermost = beyond_upper;
        step_outwards = (cells_.count[axis] + 1 - index) * stride_[axis];
      }
      if (beyond_lower > outermost) {
        outermost = beyond_lower;
        step_outwards = -index * stride_[axis];
      }
    }
    return static_cast<std::uint32_t>(cell + step_outwards);
  }

 private:
  const TileCells<Dim>& cells_;
  std::int32_t stride_[Dim];
  std::size_t total_;
};

}  // namespace

template <int Dim>
SortedTile<Dim>::SortedTile(base::MemoryMeter& memory)
    : numbers_(base::make_array_for_overwrite<float>(memory, 0)),
      names_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cell_of_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cell_begin_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim>
void SortedTile<Dim>::make_room_for(std::size_t elements, std::size_t cells) {
  const std::size_t padded = elements + kernels::widest_vector;
  base::make_room(numbers_, (Dim + 1) * padded);
  base::make_room(names_, padded);
  base::make_room(cell_of_, elements);
  base::make_room(cell_begin_, cells + 1);
  const std::size_t column = numbers_.size() / (Dim + 1);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    view_.center[axis] = numbers_.data() + axis * column;
  }
  view_.radius = numbers_.data() + Dim * column;
  view_.number = names_.data();
  view_.cell_begin = cell_begin_.data();
}

template <int Dim>
void SortedTile<Dim>::count(std::span<const Record<Dim>> records, std::size_t own,
                            const TileCells<Dim>& cells) {
  const CellOf<Dim> cell_of(cells);
  make_room_for(records.size(), cell_of.total());
  std::fill_n(cell_begin_.begin(), cell_of.total() + 1, 0u);
  for (std::size_t k = 0; k < own; ++k) {
    cell_of_[k] = cell_of.own(records[k]);
    ++cell_begin_[cell_of_[k]];
  }
  for (std::size_t k = own; k < records.size(); ++k) {
    cell_of_[k] = cell_of.copy(records[k]);
    ++cell_begin_[cell_of_[k]];
  }
  sum_up(cell_of.total());
  size_ = records.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    view_.cells[axis] = axis < Dim ? cells.count[axis] : 1;
  }
}

/// Counts become the ends of the cells.
template <int Dim>
void SortedTile<Dim>::sum_up(std::size_t cell_total) {
  std::uint32_t end = 0;
  crowding_ = 0;
  for (std::size_t cell = 0; cell <= cell_total; ++cell) {
    const std::uint64_t inhabitants = cell_begin_[cell];
    crowding_ += inhabitants * inhabitants;
    end += cell_begin_[cell];
    cell_begin_[cell] = end;
  }
}

template <int Dim>
void SortedTile<Dim>::sort(std::span<const Record<Dim>> records, float common_radius) {
  const std::size_t column = numbers_.size() / (Dim + 1);
  float* const center = numbers_.data();
  float* const radius = center + Dim * column;
  for (std::size_t k = records.size(); k-- > 0;) {
    const std::uint32_t place = --cell_begin_[cell_of_[k]];
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      center[axis * column + place] = records[k].center[axis];
    }
    if (common_radius < 0.0f) radius[place] = records[k].radius;
    names_[place] = records[k].number;
  }
  view_.common_radius = common_radius;
}

template class SortedTile<2>;
template class SortedTile<3>;

}  // namespace abut::engine
