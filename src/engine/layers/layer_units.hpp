#pragma once

#include "grid/bounds.hpp"

#include <array>
#include <cstddef>

namespace abut::engine {

/// Sizes, margins and positions beyond, in units, have squares that single precision does not hold.
inline constexpr float most_units = 0x1p60f;

/// A cell has 2^cell_shift units, and the largest reach less than 2^reach_bits, where this bounds
/// errors.
struct LayerUnits {
  int cell_shift;
  int reach_bits;
};

/// The longest axis of a box.
template <int Dim>
[[nodiscard]] double longest_axis(const grid::Bounds<Dim>& bounds);

/// The axes of a box, the shortest first; of equal ones the first.
template <int Dim>
[[nodiscard]] std::array<std::size_t, Dim> axes_by_extent(const grid::Bounds<Dim>& bounds);

/// Returns the finest units in which positions fit, if there are any: the finer, the fewer pairs
/// are left undecided. A cell has up to 2^22 of them, or more by the power of two by which it is
/// wider than `least`, which the reach needs, and on the longest axes as few as 2^16.
template <int Dim>
[[nodiscard]] LayerUnits units_for(const grid::Bounds<Dim>& bounds, double cell, double least);

}  // namespace abut::engine
