#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/frame.hpp"

#include <cstdint>
#include <span>

namespace abut::device {

/// Ends of radii that divide elements into levels, ascending; the last level has none.
using RadiusEnds = std::span<const double>;

/// Lays out the cells of each level. Levels have no slots yet. `extent` is of one element or more.
template <int Dim>
[[nodiscard]] Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, RadiusEnds ends);

}  // namespace abut::device
