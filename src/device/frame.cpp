#include "device/frame.hpp"

#include "grid/scaling.hpp"
#include "lattice/wrap_rules.hpp"

#include <algorithm>
#include <cmath>

namespace abut::device {
namespace {

/// Cells are wider than the reach by this factor: positions are whole numbers, off by 1.51 units.
constexpr double cell_margin = 1.0 + 0x1p-10;
/// Keeps reciprocals finite.
constexpr double smallest_cell = 0x1p-900;
/// Without reach any cell will do: some thousand along the longest axis.
constexpr double cells_of_points = 0x1p12;

/// Sets the cells along all axes; returns how many keys they take.
template <int Dim>
double set_cells(SizeLevel<Dim>& level, const Extent<Dim>& extent, double scale) {
  double keys = 1.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double upper = extent.upper[axis] * scale;
    level.cells[axis] = (units_along(level.axes[axis], level.units_of_one, upper) >> unit_bits) + 1;
    level.pitch[axis] = level.cells[axis] + 1;
    keys *= static_cast<double>(level.pitch[axis]);
  }
  return keys;
}

}  // namespace

template <int Dim>
Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, double slack) {
  double largest = std::max(extent.largest_radius, margin);
  for (int axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(extent.lower[axis]), std::fabs(extent.upper[axis])});
  }
  Frame<Dim> frame{};
  frame.scale = largest > grid::largest_unscaled ? grid::scale_down : 1.0;
  frame.margin = margin * frame.scale;
  frame.slack = slack * frame.scale;
  return frame;
}

template <int Dim>
CellWidths lay_out(SizeLevel<Dim>& level, const Extent<Dim>& extent, const Frame<Dim>& frame) {
  level.largest_radius = extent.largest_radius * frame.scale;
  level.largest_reach =
      level.largest_radius + extent.second_largest_radius * frame.scale + frame.margin;
  double longest = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    level.axes[axis] = {extent.lower[axis] * frame.scale, 0, nullptr};
    longest = std::max(longest, extent.upper[axis] * frame.scale - level.axes[axis].lower);
  }
  const double wanted =
      level.largest_reach > 0.0 ? level.largest_reach * cell_margin : longest / cells_of_points;
  const double narrowest = std::max({wanted, smallest_cell, frame.slack * lattice::cells_of_error});
  double cell = std::max(narrowest, longest / most_cells_along_axis);
  level.units_of_one = units_of_cell / cell;
  while (set_cells(level, extent, frame.scale) > most_keys_of_level) {
    cell *= 2.0;
    level.units_of_one = units_of_cell / cell;
  }
  return {narrowest, cell};
}

template <int Dim>
void number_keys(Frame<Dim>& frame) {
  for (std::uint32_t k = 0; k < frame.level_count; ++k) {
    frame.levels[k].first_key = frame.key_count;
    std::uint64_t keys = 1;
    for (const std::uint64_t pitch : frame.levels[k].pitch) keys *= pitch;
    frame.key_count += keys;
  }
}

template Frame<2> make_frame(const Extent<2>&, double, double);
template Frame<3> make_frame(const Extent<3>&, double, double);
template CellWidths lay_out(SizeLevel<2>&, const Extent<2>&, const Frame<2>&);
template CellWidths lay_out(SizeLevel<3>&, const Extent<3>&, const Frame<3>&);
template void number_keys(Frame<2>&);
template void number_keys(Frame<3>&);

}  // namespace abut::device
