#pragma once

#include "kernels/searched_elements.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// So many places behind the last element of each row hold none: vectors reach beyond the ends of
/// runs.
inline constexpr std::size_t plane_padding = 40;

/// Hits of an element, on average, below which few elements have some.
inline constexpr float few_hits_in_plane = 0.6f;

/// How far spheres look ahead, in columns.
struct PlaneSpan {
  float farthest;  ///< what is added to a radius, in units
  float columns_per_unit;
  std::uint32_t widest;

  [[nodiscard]] std::uint32_t of(float radius) const noexcept {
    const float columns = (radius + farthest) * columns_per_unit;
    return std::min(static_cast<std::uint32_t>(columns) + 1, widest);
  }
};

/// Few elements, sorted by rows of columns in the plane of the two longest axes of their box, the
/// first of which is axis 0 here. Rows are as wide as the reach, columns narrower. In each row the
/// columns are framed by empty ones, as many as an element may look ahead; behind them follow
/// places that hold nothing:
///
///   index   0 .. s - 1   s .. s + c - 1   s + c .. 2 s + c - 1   2 s + c
///   holds   nothing      elements         nothing                plane_padding places, far away
///
///   column = row * (2 s + c + 1) + index, and one row more that is empty
///
/// Elements within reach are in the same row, or in rows that follow each other, and no more than
/// s columns apart (docs/derivations/plane.md).
struct PlaneView : SearchedElements {
  const std::uint32_t* column;      ///< of the element
  const std::uint32_t* column_end;  ///< the place behind the last element of each column
  std::uint32_t rows;
  std::uint32_t row_length;
  PlaneSpan looked_ahead;  ///< s at most
  bool has_few_hits;       ///< as far as is known before the search

  /// The places of the row.
  [[nodiscard]] Run row(std::uint32_t k) const noexcept {
    const std::uint32_t* const end = column_end + std::size_t{k} * row_length;
    return {k == 0 ? 0 : end[-1], end[row_length - 2]};
  }

  /// Columns that the element at that place looks ahead.
  [[nodiscard]] std::uint32_t span(std::uint32_t p) const noexcept {
    return shape == ElementShape::spheres ? looked_ahead.of(size[0][p]) : looked_ahead.widest;
  }

  /// The elements that follow the one at that place in its row, as far as it looks ahead.
  [[nodiscard]] Run ahead(std::uint32_t p, std::uint32_t columns) const noexcept {
    return {p + 1, column_end[column[p] + columns]};
  }

  /// Those of the next row, as far as it looks to both sides.
  [[nodiscard]] Run across(std::uint32_t p, std::uint32_t columns) const noexcept {
    const std::uint32_t* const end = column_end + column[p] + row_length;
    return {*(end - columns - 1), end[columns]};
  }
};

}  // namespace abut::kernels
