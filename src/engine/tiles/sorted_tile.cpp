#include "engine/tiles/sorted_tile.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace abut::engine {
namespace {

/// Cell of a position along one axis, counted from 0 where copies lie: 1 makes the argument
/// positive, so that truncation is floor.
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
      stride *= cells.count[axis] + (axis == 0 ? 3 : 2);
    }
    total_ = static_cast<std::size_t>(stride);
  }

  [[nodiscard]] std::size_t total() const { return total_; }
  [[nodiscard]] std::size_t row_length() const { return static_cast<std::size_t>(stride_[1]); }

  [[nodiscard]] std::uint32_t own(const Record<Dim>& record) const {
    std::int32_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const auto last = static_cast<float>(cells_.count[axis]);
      const float q = framed(record.center[axis], cells_.per_unit[axis]);
      cell += static_cast<std::int32_t>(std::min(std::max(q, 1.0f), last)) * stride_[axis];
    }
    return static_cast<std::uint32_t>(cell);
  }

  /// The map of `own`, for the vector kernels.
  [[nodiscard]] kernels::CellMap map() const {
    kernels::CellMap map{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      map.per_unit[axis] = cells_.per_unit[axis];
      map.last[axis] = static_cast<float>(cells_.count[axis]);
      map.stride[axis] = stride_[axis];
    }
    return map;
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
      sizes_(base::make_array_for_overwrite<float>(memory, 0)),
      names_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      order_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cells_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cell_of_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cell_begin_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)) {}

template <int Dim>
void SortedTile<Dim>::make_room_for(std::size_t elements, std::size_t cells) {
  const std::size_t padded = elements + row_count_ * kernels::row_padding + kernels::widest_vector;
  base::make_room(numbers_, Dim * padded);
  base::make_room(names_, padded);
  base::make_room(cells_, padded);
  base::make_room(order_, padded);
  base::make_room(cell_of_, elements);
  base::make_room(cell_begin_, cells + 1);
  for (std::size_t axis = 0; axis < Dim; ++axis) view_.center[axis] = column(axis);
  view_.number = names_.data();
  view_.cell = cells_.data();
  view_.cell_begin = cell_begin_.data();
}

/// The cells of the records; a tile may hold any number of these.
template <int Dim>
void SortedTile<Dim>::find_cells(std::span<const Record<Dim>> records, std::size_t own,
                                 const TileCells<Dim>& cells,
                                 const kernels::ElementKernels& kernels, base::WorkCounter& work) {
  const CellOf<Dim> cell_of(cells);
  const kernels::CellMap map = cell_of.map();
  work.in_pieces(0, own, [&](std::size_t begin, std::size_t end) {
    std::uint32_t* const to = cell_of_.data() + begin;
    std::size_t k = begin + kernels.bin(records.data() + begin, end - begin, Dim, map, to);
    for (; k < end; ++k) cell_of_[k] = cell_of.own(records[k]);
  });
  work.in_pieces(own, records.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) cell_of_[k] = cell_of.copy(records[k]);
  });
}

template <int Dim>
void SortedTile<Dim>::count(std::span<const Record<Dim>> records, std::size_t own,
                            const TileCells<Dim>& cells, const kernels::ElementKernels& kernels,
                            base::WorkCounter& work) {
  const CellOf<Dim> cell_of(cells);
  row_length_ = cell_of.row_length();
  row_count_ = cell_of.total() / row_length_;
  make_room_for(records.size(), cell_of.total());
  find_cells(records, own, cells, kernels, work);

  std::uint32_t* const inhabitants = cell_begin_.data();
  std::fill_n(inhabitants, cell_of.total() + 1, 0u);
  for (std::size_t row = 1; row <= row_count_; ++row) {
    inhabitants[row * row_length_ - 1] = kernels::row_padding;
  }
  std::uint64_t shared_cells = 0;  // pairs that share a cell
  work.in_pieces(0, records.size(), [&](std::size_t begin, std::size_t end) {
    std::uint64_t in_piece = 0;
    for (const std::uint32_t cell : std::span(cell_of_).subspan(begin, end - begin)) {
      in_piece += inhabitants[cell]++;
    }
    shared_cells += in_piece;
  });
  squared_occupancy_ = 2 * shared_cells + records.size();
  size_ = records.size();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    view_.cells[axis] = axis < Dim ? cells.count[axis] : 1;
    view_.per_unit[axis] = axis < Dim ? cells.per_unit[axis] : 1.0f;
  }
}

template <int Dim>
void SortedTile<Dim>::sort(std::span<const Record<Dim>> records, const RecordSizes& sizes,
                           const kernels::ElementKernels& kernels, base::WorkCounter& work) {
  std::uint32_t* const end = cell_begin_.data();
  std::inclusive_scan(end, end + row_count_ * row_length_ + 1, end);
  work.did(row_count_ * row_length_);
  // From the last record to the first.
  work.in_pieces(0, records.size(), [&](std::size_t from, std::size_t to) {
    const std::size_t first = records.size() - to;
    for (std::size_t k = records.size() - from; k-- > first;) {
      const std::uint32_t cell = cell_of_[k];
      const std::uint32_t place = --end[cell];
      order_[place] = static_cast<std::uint32_t>(k);
      cells_[place] = cell;
    }
  });
  for (std::size_t row = 1; row <= row_count_; ++row) {
    end[row * row_length_ - 1] -= kernels::row_padding;
  }
  arrange(records, kernels, work);
  view_.shape = sizes.shape;
  view_.common_radius = sizes.common_radius;
  arrange_sizes(sizes, work);
}

/// Brings the records into order, row by row, each with its padding.
template <int Dim>
void SortedTile<Dim>::arrange(std::span<const Record<Dim>> records,
                              const kernels::ElementKernels& kernels, base::WorkCounter& work) {
  kernels::Arrangement job{};
  job.tile_records = records.data();
  job.order = order_.data();
  job.cell_begin = cell_begin_.data();
  job.row_length = row_length_;
  job.row_count = row_count_;
  for (std::size_t axis = 0; axis < Dim; ++axis) job.center[axis] = column(axis);
  job.number = names_.data();
  for (std::size_t row = kernels.arrange(job, Dim); row < row_count_; ++row) {
    const auto [first, last] = row_places(row);
    work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      for (std::size_t place = begin; place < end; ++place) {
        const Record<Dim>& record = records[order_[place]];
        for (std::size_t axis = 0; axis < Dim; ++axis) column(axis)[place] = record.center[axis];
        names_[place] = record.number;
      }
    });
    std::fill_n(column(0) + last, kernels::row_padding, kernels::far_away);
  }
}

template <int Dim>
void SortedTile<Dim>::arrange_sizes(const RecordSizes& sizes, base::WorkCounter& work) {
  const std::size_t columns = kernels::size_columns(sizes.shape, Dim);
  base::make_room(sizes_, columns * (numbers_.size() / Dim));
  for (std::size_t k = 0; k < columns; ++k) {
    float* const size = size_column(k);
    view_.size[k] = size;
    const float* const of_record = sizes.sizes.data() + k;
    for (std::size_t row = 0; row < row_count_; ++row) {
      const auto [first, last] = row_places(row);
      work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
        for (std::size_t place = begin; place < end; ++place) {
          size[place] = of_record[order_[place] * columns];
        }
      });
      std::fill_n(size + last, kernels::row_padding, 0.0f);
    }
  }
}

template <int Dim>
std::size_t SortedTile<Dim>::most_places_met() const noexcept {
  constexpr std::size_t rows_met = Dim == 2 ? 2 : 5;
  std::size_t longest = 0;
  for (std::size_t row = 0; row < row_count_; ++row) {
    const kernels::Run places = row_places(row);
    longest = std::max<std::size_t>(longest, places.end - places.begin);
  }
  return rows_met * longest;
}

template class SortedTile<2>;
template class SortedTile<3>;

}  // namespace abut::engine
