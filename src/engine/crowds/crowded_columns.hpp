#pragma once

#include "engine/layers/layer_grid.hpp"
#include "kernels/layers/layer_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::engine {

/// The rows and columns of a layer between which all crowded ones lie. What is between them is the
/// crowd.
struct CrowdedColumns {
  std::uint32_t first_row = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t last_row = 0;
  std::uint32_t first_column = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t last_column = 0;
  std::size_t crowd = 0;  ///< number of elements; 0 where there is none

  void include(std::uint32_t row, std::uint32_t column) noexcept {
    first_row = std::min(first_row, row);
    last_row = std::max(last_row, row);
    first_column = std::min(first_column, column);
    last_column = std::max(last_column, column);
  }

  template <int Dim>
  [[nodiscard]] bool hold(const LayerGrid<Dim>& grid,
                          const kernels::PositionRecord& record) const noexcept {
    const std::uint32_t row = grid.row(record);
    const std::uint32_t column = grid.column(record);
    return row >= first_row && row <= last_row && column >= first_column && column <= last_column;
  }
};

}  // namespace abut::engine
