#include "engine/clusters/cell_labels.hpp"

#include "base/asking_sort.hpp"

#include <algorithm>

namespace abut::engine {
namespace {

/// The cell of a label that two workers wanted to give at once: it has none.
constexpr std::uint32_t no_cell = ~std::uint32_t{0};

}  // namespace

CellLabels::CellLabels(base::MemoryMeter& memory)
    : labels_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
      cells_(labels_),
      order_(labels_) {}

void CellLabels::start(std::size_t most) {
  base::make_room(cells_, most + 1);
  base::make_room(order_, most);
  std::fill_n(cells_.begin(), most + 1, no_cell);
  end_of_cells_ = 0;
  most_ = most;
  ordered_ = 0;
  taken_ = 0;
}

void CellLabels::add_cells(std::size_t end) {
  if (labels_.size() < end) labels_.resize(end);
  std::fill(labels_.begin() + static_cast<std::ptrdiff_t>(end_of_cells_),
            labels_.begin() + static_cast<std::ptrdiff_t>(end), std::uint32_t{0});
  end_of_cells_ = end;
}

std::uint32_t CellLabels::give_label(std::uint32_t cell) noexcept {
  const std::size_t next = taken_.fetch_add(1, std::memory_order::relaxed) + 1;
  if (next > most_) return 0;
  const auto label = static_cast<std::uint32_t>(next);
  std::uint32_t earlier = 0;
  const bool is_first = std::atomic_ref(labels_[cell])
                            .compare_exchange_strong(earlier, label, std::memory_order::relaxed);
  if (!is_first) return earlier;
  cells_[label] = cell;
  return label;
}

std::span<const std::uint32_t> CellLabels::in_order_of_cells(base::WorkCounter& work) {
  const std::size_t end = given();
  std::size_t count = 0;
  for (std::size_t label = ordered_ + 1; label <= end; ++label) {
    if (cells_[label] != no_cell) order_[count++] = static_cast<std::uint32_t>(label);
  }
  ordered_ = end;
  const std::span order = std::span(order_).first(count);
  base::sort_asking(order.begin(), order.end(), work,
                    [&](std::uint32_t a, std::uint32_t b) { return cells_[a] < cells_[b]; });
  return order;
}

}  // namespace abut::engine
