#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::engine {

/// Labels of the cells that hold elements, 1, 2, ..., which workers give as they come to them: the
/// numbers depend on their turns, the cells that have one do not. What follows from labels is
/// brought into the order of the cells first (`in_order_of_cells`).
class CellLabels {
 public:
  explicit CellLabels(base::MemoryMeter& memory);

  /// Starts anew with at most so many labels.
  void start(std::size_t most);

  /// Makes room for cells up to `end`; those that are new have no label.
  void add_cells(std::size_t end);

  /// The label of a cell, which it gets now if it has none; 0 where there are no more. Workers may
  /// call this at once.
  [[nodiscard]] std::uint32_t label(std::uint32_t cell) noexcept {
    const std::uint32_t label = std::atomic_ref(labels_[cell]).load(std::memory_order::relaxed);
    return label != 0 ? label : give_label(cell);
  }

  /// The label of a cell, or 0.
  [[nodiscard]] std::uint32_t label_of(std::uint32_t cell) const noexcept { return labels_[cell]; }
  [[nodiscard]] std::uint32_t cell_of(std::uint32_t label) const noexcept { return cells_[label]; }

  /// Tells whether more labels were asked for than there are.
  [[nodiscard]] bool are_too_few() const noexcept {
    return taken_.load(std::memory_order::relaxed) > most_;
  }
  /// The last label that was given.
  [[nodiscard]] std::size_t given() const noexcept { return std::min(taken_.load(), most_); }

  /// The labels that were given since the last call, in the order of their cells.
  [[nodiscard]] std::span<const std::uint32_t> in_order_of_cells(base::WorkCounter& work);

 private:
  [[nodiscard]] std::uint32_t give_label(std::uint32_t cell) noexcept;

  base::Array<std::uint32_t> labels_;  ///< by cell
  base::Array<std::uint32_t> cells_;   ///< by label
  base::Array<std::uint32_t> order_;
  std::size_t end_of_cells_ = 0;
  std::size_t most_ = 0;
  std::size_t ordered_ = 0;
  std::atomic<std::size_t> taken_{0};
};

}  // namespace abut::engine
