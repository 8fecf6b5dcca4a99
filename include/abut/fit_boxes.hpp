#pragma once

#include <abut/element_view.hpp>
#include <abut/export.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <type_traits>
#include <utility>
#include <vector>

namespace abut {

namespace detail {

/// The type of the numbers of a cell: std::array<T, K>, T[K].
template <class Cell>
using NumberOfCell = std::remove_cvref_t<decltype(std::declval<const Cell&>()[0])>;

template <class Cells>
concept CellsOfNumbers =
    std::ranges::contiguous_range<Cells> && std::ranges::borrowed_range<Cells> &&
    std::ranges::sized_range<Cells> && HoldsItsNumbers<std::ranges::range_value_t<Cells>> &&
    std::integral<NumberOfCell<std::ranges::range_value_t<Cells>>>;

}  // namespace detail

/// Vertices of each cell of a mesh, seen through the caller's array: cell k has the
/// `vertices_per_cell` numbers from place k * vertices_per_cell on. It owns nothing.
class Connectivity {
 public:
  /// Views an array of cells, each an array of whole numbers: segments of 2 vertices, triangles of
  /// 3, tetrahedra of 4, or others.
  template <detail::CellsOfNumbers Cells>
  Connectivity(Cells&& cells)  // NOLINT: a mesh is given as it is
      : first_(std::ranges::data(cells)), cells_(std::ranges::size(cells)) {
    using Cell = std::ranges::range_value_t<Cells>;
    using Number = detail::NumberOfCell<Cell>;
    vertices_per_cell_ = sizeof(Cell) / sizeof(Number);
    number_bytes_ = sizeof(Number);
    is_signed_ = std::is_signed_v<Number>;
  }

  /// Number of cells.
  [[nodiscard]] std::size_t size() const noexcept { return cells_; }
  /// Number of vertices of each cell.
  [[nodiscard]] std::size_t vertices_per_cell() const noexcept { return vertices_per_cell_; }

  /// Address of the first vertex number.
  [[nodiscard]] const void* first() const noexcept { return first_; }
  /// Size of a vertex number in bytes.
  [[nodiscard]] std::size_t number_bytes() const noexcept { return number_bytes_; }
  /// True if the type of the vertex numbers is signed.
  [[nodiscard]] bool is_signed() const noexcept { return is_signed_; }

 private:
  const void* first_;
  std::size_t cells_;
  std::size_t vertices_per_cell_ = 0;
  std::size_t number_bytes_ = 0;
  bool is_signed_ = false;
};

/// Boxes that own their corners, one array for each axis; in 2D the third is empty.
struct FittedBoxes {
  int dimensions = 3;                        ///< 2 or 3
  std::array<std::vector<double>, 3> lower;  ///< lower bounds, by axis
  std::array<std::vector<double>, 3> upper;  ///< upper bounds, by axis

  /// Number of boxes.
  [[nodiscard]] std::size_t size() const noexcept { return lower[0].size(); }

  /// Views the boxes. The view is valid as long as these boxes do not change.
  [[nodiscard]] ABUT_API ElementView view() const;
};

/// Computes the smallest box around the vertices of each cell, wider by `skin` on every side and
/// rounded outwards, so that no box is too small. `vertices` are the centers of a view; `skin` is
/// in the unit of the positions, finite and >= 0.
///
/// Throws Error{invalid_input} for a vertex number that does not exist (with the cell and the
/// number), for a vertex of a cell that is not finite, and for a skin out of range.
[[nodiscard]] ABUT_API FittedBoxes fit_boxes(const ElementView& vertices, const Connectivity& cells,
                                             double skin = 0.0);

/// Computes boxes as fit_boxes does, for vertices given as points of three numbers.
template <class Points>
requires detail::PointsOf<Points, 3>
[[nodiscard]] FittedBoxes fit_boxes_3d(Points&& vertices, const Connectivity& cells,
                                       double skin = 0.0) {
  return fit_boxes(spheres(static_cast<Points&&>(vertices), 0.0), cells, skin);
}
/// Computes rectangles as fit_boxes does, for vertices given as points of two numbers.
template <class Points>
requires detail::PointsOf<Points, 2>
[[nodiscard]] FittedBoxes fit_boxes_2d(Points&& vertices, const Connectivity& cells,
                                       double skin = 0.0) {
  return fit_boxes(discs(static_cast<Points&&>(vertices), 0.0), cells, skin);
}

}  // namespace abut
