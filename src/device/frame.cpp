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
/// Positions in stretches are whole numbers of 62 bits.
constexpr double most_cells_of_stretches = 0x1p41;

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

  [[nodiscard]] double narrowest_cell() const {
    const double reach = largest_radius() + second_largest_radius() + frame_.margin;
    if (reach > 0.0) return std::max(reach * cell_margin, smallest_cell);
    return std::max(longest_ / cells_of_points, smallest_cell);
  }

  Frame<Dim> make(RadiusEnds ends) {
    narrowest_along_ = longest_ / most_cells_along_axis;
    return make_levels(ends, std::max(narrowest_cell(), narrowest_along_),
                       std::numeric_limits<double>::infinity());
  }

  Frame<Dim> make(RadiusEnds ends, const StretchedAxes<Dim>& axes) {
    axes_ = &axes;
    narrowest_along_ = axes.longest / most_cells_along_axis;
    Frame<Dim> frame = make_levels(ends, axes.cell, axes.cell);
    for (int axis = 0; axis < Dim; ++axis) {
      frame.axes[axis].stretches = axes.stretches[axis];
      frame.axes[axis].stretch_count = axes.counts[axis];
    }
    return frame;
  }

 private:
  /// Without reach any cell will do: some thousand along the longest axis.
  static constexpr double cells_of_points = 0x1p12;

  [[nodiscard]] double largest_radius() const { return extent_.largest_radius * frame_.scale; }
  [[nodiscard]] double second_largest_radius() const {
    return extent_.second_largest_radius * frame_.scale;
  }

  /// `last_cell` for the last level, and none wider than `widest`.
  Frame<Dim> make_levels(RadiusEnds ends, double last_cell, double widest) {
    frame_.level_count = static_cast<std::uint32_t>(ends.size()) + 1;
    SizeLevel<Dim>& last = frame_.levels[ends.size()];
    last.radius_end = std::numeric_limits<double>::infinity();
    last.largest_radius = largest_radius();
    frame_.cell = lay_out(last, last_cell, widest);
    for (std::size_t k = ends.size(); k-- > 0;) {
      SizeLevel<Dim>& level = frame_.levels[k];
      level.radius_end = ends[k];
      level.largest_radius = std::min(ends[k] * frame_.scale, second_largest_radius());
      const double reach = 2.0 * level.largest_radius + frame_.margin;
      lay_out(level, std::max({reach * cell_margin, smallest_cell, narrowest_along_}), frame_.cell);
    }
    number_keys();
    return frame_;
  }

  /// Sets the cells of a level, the smallest that may be; returns their width.
  double lay_out(SizeLevel<Dim>& level, double cell, double widest) const {
    while (true) {
      cell = std::min(cell, widest);
      level.units_of_one = units_of_cell / cell;
      level.finer = axes_ == nullptr ? 1.0 : axes_->cell / cell;
      double keys = 1.0;
      for (int axis = 0; axis < Dim; ++axis) {
        const double cells = cells_along(axis, level);
        keys *= cells + 1.0;
        if (cells > most_cells_of_stretches) continue;
        level.cells[axis] = static_cast<std::uint64_t>(cells);
        level.pitch[axis] = level.cells[axis] + 1;
      }
      if (keys <= most_keys_of_level || cell == widest) return cell;
      cell *= 2.0;
    }
  }

  /// Whole, unless there are far too many.
  [[nodiscard]] double cells_along(int number, const SizeLevel<Dim>& level) const {
    Axis axis = frame_.axes[number];
    if (axes_ != nullptr) {
      const double before = static_cast<double>(axes_->last[number].first_cell) * level.finer;
      if (before > most_cells_of_stretches) return most_keys_of_level;
      axis.stretches = &axes_->last[number];
      axis.stretch_count = 1;
    }
    const double upper = extent_.upper[number] * frame_.scale;
    return static_cast<double>((units_along(axis, level, upper) >> unit_bits) + 1);
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
  const StretchedAxes<Dim>* axes_ = nullptr;
  Frame<Dim> frame_{};
  double longest_ = 0.0;
  double narrowest_along_ = 0.0;  ///< of cells, for the sake of the longest axis
};

}  // namespace

template <int Dim>
Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, RadiusEnds ends) {
  return FrameBuilder<Dim>(extent, margin).make(ends);
}

template <int Dim>
Frame<Dim> make_frame(const Extent<Dim>& extent, double margin, RadiusEnds ends,
                      const StretchedAxes<Dim>& axes) {
  return FrameBuilder<Dim>(extent, margin).make(ends, axes);
}

template <int Dim>
double narrowest_cell(const Extent<Dim>& extent, double margin) {
  return FrameBuilder<Dim>(extent, margin).narrowest_cell();
}

template Frame<2> make_frame(const Extent<2>&, double, RadiusEnds);
template Frame<3> make_frame(const Extent<3>&, double, RadiusEnds);
template Frame<2> make_frame(const Extent<2>&, double, RadiusEnds, const StretchedAxes<2>&);
template Frame<3> make_frame(const Extent<3>&, double, RadiusEnds, const StretchedAxes<3>&);
template double narrowest_cell(const Extent<2>&, double);
template double narrowest_cell(const Extent<3>&, double);

}  // namespace abut::device
