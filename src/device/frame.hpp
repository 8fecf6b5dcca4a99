#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/frame.hpp"

#include <cstdint>

namespace abut::device {

/// An axis, or a stretch of it, has fewer cells: positions in doubles are then off by a quarter of
/// a unit at most.
inline constexpr double most_cells_along_axis = 0x1p30;
/// The keys of all levels together stay below 2^62.
inline constexpr double most_keys_of_level = 0x1p59;

/// Scale, margin and slack for elements of that extent; no levels yet.
template <int Dim>
[[nodiscard]] Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, double slack);

/// What cells of a level may be: how wide for the reach, and how wide in one piece, where the keys
/// of narrower ones would be too many.
struct CellWidths {
  double narrowest;
  double in_one_piece;
};

/// Sets reach and axes of a level; `extent` is that of its elements, of one or more. Its cells are
/// as wide as they must be in one piece.
template <int Dim>
CellWidths lay_out(SizeLevel<Dim>& level, const Extent<Dim>& extent, const Frame<Dim>& frame);

/// Gives each level its keys.
template <int Dim>
void number_keys(Frame<Dim>& frame);

}  // namespace abut::device
