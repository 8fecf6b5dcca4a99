#pragma once

#include "base/array.hpp"
#include "exact/sphere_predicate.hpp"
#include "grid/bounds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lattice {

/// Mask of the places in open space from which an element may reach any of some others: their box
/// widened by the reach, and in it coarse cells that the reach of one of them covers. In doubt a
/// place belongs to the mask. It keeps its memory.
///
/// WHY NOTHING WITHIN REACH IS OUTSIDE. On each axis x is within reach of an element at c only if
/// c - R <= x <= c + R, R the sum of both radii and the margin. R, c - R and c + R are rounded
/// outwards, and the cell of a coordinate is a monotone function of it as computed: subtraction,
/// product with a positive number, truncation and clamping are monotone. So the cell of x lies
/// between those of the two ends, which are covered with all between them.
template <int Dim>
class ReachMask {
 public:
  explicit ReachMask(base::MemoryMeter& memory)
      : bits_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)) {}

  /// The widened box alone. `others_radius` is the largest radius of those that will be asked
  /// about.
  void cover_box(const grid::Bounds<Dim>& bounds, double others_radius, double margin) noexcept;

  /// Cells too; after cover_box for the same elements.
  void cover_cells(std::span<const exact::Sphere<Dim>> spheres);

  /// True if all of a box is covered, so that elements in it need not be asked about.
  [[nodiscard]] bool covers_all_of(const grid::Bounds<Dim>& bounds) const noexcept {
    bool inside = !has_cells_;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      inside = inside && lower_[axis] <= bounds.lower[axis] && bounds.upper[axis] <= upper_[axis];
    }
    return inside;
  }

  [[nodiscard]] bool may_be_within_reach(const exact::Sphere<Dim>& sphere) const noexcept {
    bool inside = true;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      inside = inside && lower_[axis] <= sphere.center[axis] && sphere.center[axis] <= upper_[axis];
    }
    return inside && (!has_cells_ || is_covered(sphere));
  }

 private:
  [[nodiscard]] std::size_t cell(std::size_t axis, double x) const noexcept {
    const double cells = (x - lower_[axis]) * per_length_[axis];
    return static_cast<std::size_t>(std::clamp(cells, 0.0, last_cell_[axis]));
  }

  [[nodiscard]] bool is_covered(const exact::Sphere<Dim>& sphere) const noexcept {
    std::size_t row = 0;
    for (std::size_t axis = Dim - 1; axis > 0; --axis) {
      row = row * counts_[axis] + cell(axis, sphere.center[axis]);
    }
    const std::size_t column = cell(0, sphere.center[0]);
    return (bits_[row * words_of_row_ + column / 64] >> (column % 64) & 1U) != 0;
  }

  [[nodiscard]] double reach_of(double radius) const noexcept;
  [[nodiscard]] bool divide() noexcept;
  void cover(const exact::Sphere<Dim>& sphere) noexcept;
  void cover_row(std::size_t row, std::size_t first, std::size_t last) noexcept;

  std::array<double, Dim> lower_{};
  std::array<double, Dim> upper_{};
  double others_radius_ = 0.0;
  double margin_ = 0.0;
  double largest_reach_ = 0.0;
  bool in_range_ = false;

  bool has_cells_ = false;
  std::array<std::size_t, Dim> counts_{};
  std::array<double, Dim> per_length_{};
  std::array<double, Dim> last_cell_{};
  std::size_t words_of_row_ = 0;
  base::Array<std::uint64_t> bits_;
};

}  // namespace abut::lattice
