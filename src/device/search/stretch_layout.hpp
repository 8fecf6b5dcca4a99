#pragma once

#include "device/bodies/frame.hpp"
#include "device/executor.hpp"
#include "device/frame.hpp"
#include "device/search/axis_stretches.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace abut::device {

/// Divides the axes of a level that is far wider than its elements need into stretches: gaps wider
/// than a cell are closed, so that there are few cells for each element however far apart they are.
/// The level knows then how many stretches there are; they are found again where they are needed,
/// axis by axis, so that those of one at a time take memory.
template <class Spheres, class E>
class StretchLayout {
  static constexpr int Dim = Spheres::dimensions;

 public:
  StretchLayout(E& executor, const Spheres& elements, const Frame<Dim>& frame,
                std::uint32_t level) {
    for (int axis = 0; axis < Dim; ++axis) {
      axes_.emplace_back(executor, elements, frame, level, axis);
      axes_.back().forget_numbers();
    }
  }

  /// Lays out the narrowest cells whose keys fit. Those in one piece do, and wider ones.
  void lay_out(SizeLevel<Dim>& level, const CellWidths& widths) {
    int too_narrow = -1;
    // By exponents: their quotient may exceed all doubles.
    int fits = std::ilogb(widths.in_one_piece) - std::ilogb(widths.narrowest) + 1;
    while (fits - too_narrow > 1) {
      const int middle = too_narrow + (fits - too_narrow) / 2;
      (divide(level, std::ldexp(widths.narrowest, middle)) ? fits : too_narrow) = middle;
    }
    divide(level, std::ldexp(widths.narrowest, fits));
  }

 private:
  /// Divides all axes by cells of that width; returns whether their keys fit.
  bool divide(SizeLevel<Dim>& level, double cell) {
    level.units_of_one = units_of_cell / cell;
    level.widest_gap = cell;
    double keys = 1.0;
    double longest = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      const auto size = axes_[static_cast<std::size_t>(axis)].measure(cell, level.units_of_one);
      level.axes[axis].stretch_count = static_cast<std::uint32_t>(size.stretches);
      level.cells[axis] = size.cells;
      level.pitch[axis] = size.cells + 1;
      longest = std::max(longest, size.longest);
      keys *= static_cast<double>(level.pitch[axis]);
    }
    return keys <= most_keys_of_level && longest <= cell * most_cells_along_axis;
  }

  std::vector<AxisStretches<Spheres, E>> axes_;
};

}  // namespace abut::device
