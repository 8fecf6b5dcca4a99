#pragma once

#include "engine/layers/layer_grid.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace abut::engine {

/// The elements of a set that is a part of a larger one. Their own numbers are their places in it.
struct PartNumbers {
  const std::uint32_t* given =
      nullptr;  ///< number in the whole by place; null where a set is whole
  const std::uint32_t* marks = nullptr;  ///< by place
  std::uint32_t used_marks = 0;          ///< of any of its elements
  std::size_t depth = 0;                 ///< parts that this one is a part of, and itself
  std::size_t around = 0;                ///< parts whose search goes on while this one's does
  /// Cells of the layers from which the part was taken: those of its own are narrower.
  double cell_around = std::numeric_limits<double>::infinity();
  bool long_rows_around = false;  ///< LayerGrid::has_long_rows of these layers
  /// Unit of the whole to which its pairs belong; none where the units of its search are those.
  std::optional<std::uint64_t> unit = {};

  [[nodiscard]] bool is_part() const noexcept { return given != nullptr; }

  /// Tells whether the part has to find a pair. Each part has a mark for elements that stand in it
  /// for their pairs with others only; two that have one in common meet elsewhere.
  [[nodiscard]] bool is_wanted(std::uint32_t a, std::uint32_t b) const noexcept {
    return (marks[a] & marks[b]) == 0;
  }

  /// A mark that no element has; 0 where all are in use.
  [[nodiscard]] std::uint32_t free_mark() const noexcept {
    constexpr std::uint64_t one = 1;
    return static_cast<std::uint32_t>(one << std::countr_one(used_marks));
  }

  /// The widest cells in which crowds of this set may become parts: where they are hardly narrower
  /// than those around, these would bring nothing.
  [[nodiscard]] double widest_cell() const noexcept {
    constexpr double most_of_cell_around = 0.8;
    return most_of_cell_around * cell_around;
  }

  /// Of two crowds at the ends of a long row no part is narrower; rows across it tell them apart.
  [[nodiscard]] RowsOfThin rows_of_thin() const noexcept {
    return long_rows_around ? RowsOfThin::across : RowsOfThin::along;
  }

  /// Tells whether crowds of this set, in these layers, may become parts.
  template <int Dim>
  [[nodiscard]] bool may_have_parts(const LayerGrid<Dim>& layers) const noexcept {
    const bool tells_apart = long_rows_around && !layers.has_long_rows();
    return layers.has_wide_cells() && (layers.cell() <= widest_cell() || tells_apart) &&
           free_mark() != 0;
  }

  /// The unit of the whole in which a unit of the search is.
  [[nodiscard]] std::uint64_t unit_of(std::uint64_t own) const noexcept {
    return unit.value_or(own);
  }
};

}  // namespace abut::engine
