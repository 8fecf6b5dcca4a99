#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/frame.hpp"

#include <cstdint>
#include <span>

namespace abut::device {

/// Ends of radii that divide elements into levels, ascending; the last level has none.
using RadiusEnds = std::span<const double>;

/// An axis, or a stretch of it, has fewer cells: positions in doubles are then off by a quarter of
/// a unit at most.
inline constexpr double most_cells_along_axis = 0x1p30;
/// The keys of all levels together stay below 2^62.
inline constexpr double most_keys_of_level = 0x1p59;

/// The stretches of each axis in the memory of a device, made for cells of one width.
template <int Dim>
struct StretchedAxes {
  double cell = 0.0;     ///< scaled
  double longest = 0.0;  ///< stretch of all
  const Stretch* stretches[Dim] = {};
  std::uint32_t counts[Dim] = {};
  Stretch last[Dim] = {};  ///< the last of each axis
};

/// Lays out the cells of each level. Levels have no slots yet. `extent` is of one element or more.
/// Where they would be too many for the keys, cells are wider than the reach.
template <int Dim>
[[nodiscard]] Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, RadiusEnds ends);

/// The same in stretches, which closed the gaps that are wider than a cell of the last level.
template <int Dim>
[[nodiscard]] Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, RadiusEnds ends,
                                    const StretchedAxes<Dim>& axes);

/// The width that the cells of the last level should have, scaled.
template <int Dim>
[[nodiscard]] double narrowest_cell(const Extent<Dim>& extent, double margin);

}  // namespace abut::device
