#pragma once

#include "exact/sphere.hpp"
#include "grid/bounds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// Coarse cells over a box, none narrower than the reach: elements within reach of each other are
/// in equal or adjacent cells.
///
///   cell     begin + (c_x * count_y + c_y) * count_z + c_z
template <int Dim>
class ClusterGrid {
 public:
  using Coordinates = std::array<std::uint32_t, Dim>;

  /// The grid over a box, numbered from `begin` on, that has about as many cells as wanted where
  /// that does not make them narrower than `reach`; never more than 2^Dim times as many.
  ClusterGrid(const grid::Bounds<Dim>& box, double reach, double cells, std::uint32_t begin);

  /// Cells of the size of the reach in the box.
  [[nodiscard]] double reaches() const noexcept { return reaches_; }

  [[nodiscard]] std::uint32_t begin() const noexcept { return begin_; }
  [[nodiscard]] std::uint32_t end() const noexcept { return begin_ + size_; }

  /// The cell of a sphere whose center is in the box.
  [[nodiscard]] std::uint32_t cell(const exact::Sphere<Dim>& sphere) const noexcept {
    Coordinates coordinates{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      const double along = (sphere.center[axis] - lower_[axis]) * cells_of_one_;
      coordinates[axis] = std::min(static_cast<std::uint32_t>(along), count_[axis] - 1);
    }
    return cell(coordinates);
  }

  [[nodiscard]] std::uint32_t cell(const Coordinates& coordinates) const noexcept {
    std::uint32_t cell = 0;
    for (std::size_t axis = 0; axis < Dim; ++axis) cell = cell * count_[axis] + coordinates[axis];
    return begin_ + cell;
  }

  /// Calls body(cell) for each adjacent cell with a higher number.
  template <class Body>
  void for_each_next(std::uint32_t cell, Body&& body) const {
    const Coordinates middle = coordinates(cell);
    Coordinates first{};
    Coordinates last{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      first[axis] = middle[axis] - (middle[axis] > 0 ? 1 : 0);
      last[axis] = std::min(middle[axis] + 1, count_[axis] - 1);
    }
    Coordinates next = first;
    while (true) {
      const std::uint32_t number = this->cell(next);
      if (number > cell) body(number);
      std::size_t axis = Dim;
      while (axis > 0 && next[axis - 1] == last[axis - 1]) --axis;
      if (axis == 0) return;
      ++next[axis - 1];
      for (; axis < Dim; ++axis) next[axis] = first[axis];
    }
  }

 private:
  [[nodiscard]] Coordinates coordinates(std::uint32_t cell) const noexcept {
    Coordinates result{};
    cell -= begin_;
    for (std::size_t axis = Dim; axis-- > 0;) {
      result[axis] = cell % count_[axis];
      cell /= count_[axis];
    }
    return result;
  }

  std::array<double, Dim> lower_;
  double reaches_;
  double cells_of_one_;
  Coordinates count_{};
  std::uint32_t begin_;
  std::uint32_t size_ = 1;
};

}  // namespace abut::engine
