#include "engine/tiles/cross_level_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace abut::engine {
namespace {

/// Positions that are this uncertain, in cells, lie in the next cell at most.
constexpr double cell_slack = 0x1p-8;

/// Beyond this many units squares might overflow, and the coarse element covers whatever it may
/// reach.
constexpr double too_large_to_square = 0x1p400;

/// Beyond this many units the filter's error exceeds a thousandth of a tile.
constexpr double farthest = 0x1p10;

/// A box that reaches farther out of the tile is cut off here: its own elements lie between 0 and
/// 1, and nothing of them, nor of the margin, reaches as far as another 1.
constexpr double box_horizon = 4.0;

/// The distance of a position from the cells [first, end) of one axis, in the tile's unit.
double outside(double position, double first, double end, double cell_size) {
  return std::max({0.0, (first - cell_slack) * cell_size - position,
                   position - (end + cell_slack) * cell_size});
}

std::int32_t cell_between(double q, std::int32_t lowest, std::int32_t highest) {
  return static_cast<std::int32_t>(
      std::clamp(q, static_cast<double>(lowest), static_cast<double>(highest)));
}

/// The squared half chord that a row cuts from the ball, its distance to the center given.
double square_of_half_chord(double reach, double beyond_y, double beyond_z) {
  if (!(reach < too_large_to_square)) return std::numeric_limits<double>::max();
  return reach * reach - beyond_y * beyond_y - beyond_z * beyond_z;
}

/// The cells that a coarse element may reach: a box of them, and where it is a sphere a ball.
template <int Dim>
struct Field {
  std::array<double, 3> center{};
  double reach = 2.0 * too_large_to_square;  ///< of a box: it cuts no row short
  std::array<std::int32_t, 3> first{1, 1, 0};
  std::array<std::int32_t, 3> last{1, 1, 0};
  std::array<double, 3> per_unit{};  ///< cells; divisions are few, rows are many
};

template <int Dim>
Field<Dim> field_of(const kernels::TileView& tile, const TileFrame<Dim>& frame,
                    const exact::Elements<Dim>& elements, std::uint32_t coarse) {
  constexpr double roundings = 1.0 + 0x1p-18;
  const exact::Sphere<Dim>& sphere = elements[coarse];
  Field<Dim> field;
  const double wider = frame.margin + position_slack * frame.grid.cell_size * frame.unit;
  double before = 2.0 * frame.largest_radius + wider;
  double behind = wider;
  if (!elements.are_boxes()) {
    before = behind = sphere.radius * frame.unit + frame.largest_radius + wider;
    field.reach = std::min(before * roundings, field.reach);
  }
  const auto position = [&](double x, std::size_t axis) {
    return std::clamp(frame.position(x, axis), -too_large_to_square, too_large_to_square);
  };
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double end =
        elements.are_boxes() ? elements.boxes[coarse].upper[axis] : sphere.center[axis];
    field.center[axis] = position(sphere.center[axis], axis);
    field.per_unit[axis] = 1.0 / frame.cell_size[axis];
    const double lower = (field.center[axis] - before * roundings) * field.per_unit[axis];
    const double upper = (position(end, axis) + behind * roundings) * field.per_unit[axis];
    field.first[axis] = cell_between(lower - cell_slack + 1.0, 1, tile.cells[axis]);
    field.last[axis] = cell_between(upper + cell_slack + 1.0, 1, tile.cells[axis]);
  }
  return field;
}

}  // namespace

template <int Dim>
CrossLevelRuns<Dim>::CrossLevelRuns(base::MemoryMeter& memory)
    : runs_(base::make_array_for_overwrite<kernels::Run>(memory, 0)) {}

template <int Dim>
std::span<const kernels::Run> CrossLevelRuns<Dim>::runs(const kernels::TileView& tile,
                                                        const TileFrame<Dim>& frame,
                                                        const exact::Elements<Dim>& elements,
                                                        std::uint32_t coarse) {
  const Field<Dim> field = field_of(tile, frame, elements, coarse);
  const auto& [center, reach, first, last, per_unit] = field;
  const auto rows = static_cast<std::size_t>(last[1] - first[1] + 1) *
                    static_cast<std::size_t>(last[2] - first[2] + 1);
  base::make_room(runs_, rows);
  rows_ = rows;

  const double q = center[0] * per_unit[0] + 1.0;
  std::size_t count = 0;
  for (std::int32_t z = first[2]; z <= last[2]; ++z) {
    double beyond_z = 0.0;
    if constexpr (Dim == 3) beyond_z = outside(center[2], z - 1, z, frame.cell_size[2]);
    for (std::int32_t y = first[1]; y <= last[1]; ++y) {
      const double beyond_y = outside(center[1], y - 1, y, frame.cell_size[1]);
      const double square = square_of_half_chord(reach, beyond_y, beyond_z);
      if (square < 0.0) continue;
      const double half = std::sqrt(square) * per_unit[0] + cell_slack;
      const std::int32_t from = cell_between(q - half, first[0], last[0]);
      const std::int32_t to = cell_between(q + half, first[0], last[0]);
      const std::uint32_t* row = tile.cell_begin + z * tile.layer_length() + y * tile.row_length();
      if (row[from] < row[to + 1]) runs_[count++] = {row[from], row[to + 1]};
    }
  }
  return std::span(runs_).first(count);
}

namespace {

template <int Dim>
std::optional<kernels::CoarseElement> sphere_in(const TileFrame<Dim>& frame,
                                                const exact::Sphere<Dim>& sphere) {
  kernels::CoarseElement coarse{};
  const double radius = sphere.radius * frame.unit;
  double largest = std::max(1.0, radius);
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const double x = frame.position(sphere.center[axis], axis);
    largest = std::max(largest, std::fabs(x));
    coarse.center[axis] = static_cast<float>(x);
  }
  if (largest > farthest) return std::nullopt;
  coarse.size[0] = static_cast<float>(radius);
  coarse.slack = static_cast<float>(largest * (4.0 * kernels::filter_error));
  return coarse;
}

template <int Dim>
kernels::CoarseElement box_in(const TileFrame<Dim>& frame, const exact::Box<Dim>& box) {
  kernels::CoarseElement coarse{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    const auto position = [&](double x) {
      return std::clamp(frame.position(x, axis), -box_horizon, box_horizon);
    };
    const double lower = position(box.lower[axis]);
    coarse.center[axis] = static_cast<float>(lower);
    coarse.size[axis] = static_cast<float>(position(box.upper[axis]) - lower);
  }
  coarse.slack = static_cast<float>(2.0 * box_horizon * (4.0 * kernels::filter_error));
  return coarse;
}

}  // namespace

template <int Dim>
std::optional<kernels::CoarseElement> coarse_element_in(const TileFrame<Dim>& frame,
                                                        const exact::Elements<Dim>& elements,
                                                        std::uint32_t number) {
  std::optional<kernels::CoarseElement> coarse = elements.are_boxes()
                                                     ? box_in(frame, elements.boxes[number])
                                                     : sphere_in(frame, elements[number]);
  if (coarse) coarse->number = number;
  return coarse;
}

template class CrossLevelRuns<2>;
template class CrossLevelRuns<3>;
template std::optional<kernels::CoarseElement> coarse_element_in(const TileFrame<2>&,
                                                                 const exact::Elements<2>&,
                                                                 std::uint32_t);
template std::optional<kernels::CoarseElement> coarse_element_in(const TileFrame<3>&,
                                                                 const exact::Elements<3>&,
                                                                 std::uint32_t);

}  // namespace abut::engine
