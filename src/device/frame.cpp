#include "device/frame.hpp"

#include "grid/scaling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::device {
namespace {

/// Cells are wider than the reach by this factor: positions are whole numbers, off by 1.51 units.
constexpr double cell_margin = 1.0 + 0x1p-10;
/// Keeps reciprocals finite.
constexpr double smallest_cell = 0x1p-900;
/// An axis has fewer cells: positions in doubles are then off by a quarter of a unit at most.
constexpr double most_cells_along_axis = 0x1p30;
/// The keys of all levels together stay below 2^62.
constexpr double most_keys_of_level = 0x1p59;

template <int Dim>
double scale_of(const Extent<Dim>& extent, double margin) {
  double largest = std::max(extent.largest_radius, margin);
  for (int axis = 0; axis < Dim; ++axis) {
    largest = std::max({largest, std::fabs(extent.lower[axis]), std::fabs(extent.upper[axis])});
  }
  return largest > grid::largest_unscaled ? grid::scale_down : 1.0;
}

template <int Dim>
class FrameBuilder {
 public:
  FrameBuilder(const Extent<Dim>& extent, double margin) : extent_(extent) {
    frame_.scale = scale_of(extent, margin);
    frame_.margin = margin * frame_.scale;
    for (int axis = 0; axis < Dim; ++axis) {
      frame_.axes[axis] = {extent.lower[axis] * frame_.scale, nullptr, 0};
      const double length = extent.upper[axis] * frame_.scale - frame_.axes[axis].lower;
      longest_ = std::max(longest_, length);
    }
  }

  Frame<Dim> make(RadiusEnds ends) {
    const double second_largest = extent_.second_largest_radius * frame_.scale;
    const double last_reach =
        extent_.largest_radius * frame_.scale + second_largest + frame_.margin;
    frame_.level_count = static_cast<std::uint32_t>(ends.size()) + 1;
    double widest = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = frame_.level_count; k-- > 0;) {
      SizeLevel<Dim>& level = frame_.levels[k];
      const bool is_last = k + 1 == frame_.level_count;
      level.radius_end = is_last ? std::numeric_limits<double>::infinity() : ends[k];
      level.largest_radius = is_last ? extent_.largest_radius * frame_.scale
                                     : std::min(level.radius_end * frame_.scale, second_largest);
      const double reach = is_last ? last_reach : 2.0 * level.largest_radius + frame_.margin;
      const double cell = lay_out(level, reach, widest);
      if (is_last) widest = cell;
      level.finer = widest / cell;
    }
    number_keys();
    return frame_;
  }

 private:
  /// Sets the cells of a level, the smallest that may be; returns their width.
  double lay_out(SizeLevel<Dim>& level, double reach, double widest) const {
    double cell = std::max({reach * cell_margin, smallest_cell, longest_ / most_cells_along_axis});
    while (true) {
      cell = std::min(cell, widest);
      level.units_of_one = units_of_cell / cell;
      double keys = 1.0;
      for (int axis = 0; axis < Dim; ++axis) {
        const double upper = extent_.upper[axis] * frame_.scale;
        level.cells[axis] =
            static_cast<std::uint64_t>(units_along(frame_.axes[axis], level, upper) >> unit_bits) +
            1;
        level.pitch[axis] = level.cells[axis] + 1;
        keys *= static_cast<double>(level.pitch[axis]);
      }
      if (keys <= most_keys_of_level) return cell;
      cell *= 2.0;
    }
  }

  void number_keys() {
    for (std::uint32_t k = 0; k < frame_.level_count; ++k) {
      SizeLevel<Dim>& level = frame_.levels[k];
      level.first_key = frame_.key_count;
      std::uint64_t keys = 1;
      for (const std::uint64_t pitch : level.pitch) keys *= pitch;
      frame_.key_count += keys;
    }
  }

  const Extent<Dim>& extent_;
  Frame<Dim> frame_{};
  double longest_ = 0.0;
};

}  // namespace

template <int Dim>
Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, RadiusEnds ends) {
  return FrameBuilder<Dim>(extent, margin).make(ends);
}

template Frame<2> make_frame(const Extent<2>&, double, RadiusEnds);
template Frame<3> make_frame(const Extent<3>&, double, RadiusEnds);

}  // namespace abut::device
