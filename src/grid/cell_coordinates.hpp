#pragma once

#include "base/array.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::grid {

/// The integerised coordinates of all elements (book: x_int, y_int, z_int), counted from 0, as the
/// mapping left them: algorithms clear their lists with these, wherever elements have moved since.
template <int Dim>
class CellCoordinates {
 public:
  CellCoordinates(std::size_t element_count, base::MemoryMeter& memory)
      : CellCoordinates(element_count, memory, std::make_index_sequence<Dim>{}) {}

  [[nodiscard]] std::size_t element_count() const noexcept { return axes_[0].size(); }

  [[nodiscard]] std::int32_t x(std::size_t element) const noexcept { return axes_[0][element]; }
  [[nodiscard]] std::int32_t y(std::size_t element) const noexcept { return axes_[1][element]; }
  [[nodiscard]] std::int32_t z(std::size_t element) const noexcept requires(Dim == 3) {
    return axes_[2][element];
  }

  [[nodiscard]] base::Array<std::int32_t>& axis(std::size_t axis) noexcept { return axes_[axis]; }
  [[nodiscard]] const base::Array<std::int32_t>& axis(std::size_t axis) const noexcept {
    return axes_[axis];
  }

  /// Cells run from 0 to cell_count[axis] - 1.
  std::array<std::int32_t, Dim> cell_count{};

  /// Cells of the plain grid, before empty gaps are collapsed: what head arrays of the book's size
  /// would need. Equal to cell_count when nothing was collapsed.
  std::array<double, Dim> uncollapsed_cell_count{};

 private:
  template <std::size_t... Axis>
  CellCoordinates(std::size_t element_count, base::MemoryMeter& memory,
                  std::index_sequence<Axis...>)
      : axes_{
            ((void)Axis, base::make_array_for_overwrite<std::int32_t>(memory, element_count))...} {}

  std::array<base::Array<std::int32_t>, Dim> axes_;
};

}  // namespace abut::grid
