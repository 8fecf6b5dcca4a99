#include "engine/layers/coarse_in_layers.hpp"

#include "engine/layers/layer_units.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace abut::engine {
namespace {

/// More than what rounds a reach and a position.
constexpr double roundings = 0x1p-18;

/// Sets the size of a coarse element.
template <int Dim>
void set_size(const kernels::PositionMap& map, const exact::Elements<Dim>& coarse, std::size_t k,
              kernels::FarSphere& element) {
  if (!coarse.are_boxes()) {
    element.radius = kernels::length_in_units(coarse[k].radius, map);
    return;
  }
  const kernels::BoxSize<Dim> size(kernels::strided_boxes(coarse.boxes),
                                   static_cast<std::uint32_t>(k), map);
  element.radius = size.radius;
  std::copy_n(size.width, Dim, element.width);
}

/// Sets the bounds of its reach, which is the same for all spheres of one radius.
template <int Dim>
void set_reach(const LayerGrid<Dim>& grid, kernels::FarSphere& element) {
  const float margin = grid.margin();
  const float slack = kernels::far_slack(element.radius, margin);
  float reach = margin;
  if (!grid.has_widths()) reach += element.radius;
  if (grid.shape() == kernels::ElementShape::equal_spheres) {
    reach += grid.largest_size();
    const float nearest = std::max(reach - slack, 0.0f);
    const float farthest = reach + slack;
    element.nearest = nearest * nearest;
    element.farthest = farthest * farthest;
  } else {
    element.nearest = reach - slack;
    element.farthest = reach + slack;
  }
}

/// Sets the layers that it may meet from a position on their axis.
template <int Dim>
void set_layers(const LayerGrid<Dim>& grid, double position, kernels::FarSphere& element) {
  const double margin = double{grid.margin()} + 8.0;
  const double largest = grid.largest_size();
  const double below = grid.has_widths() ? largest : element.radius + largest;
  const double above = grid.has_widths() ? element.width[grid.layer_axis()] : below;
  const double more = margin + roundings * (below + above + margin + std::fabs(position));
  const auto layers = static_cast<double>(grid.layer_count());
  const auto layer = [&](double x) { return std::floor(std::ldexp(x, -grid.map().layer_shift)); };
  const double first = std::clamp(layer(position - (below + more)), 0.0, layers);
  const double last = std::min(layer(position + (above + more)), layers - 1.0);
  const bool is_none = first > last;
  element.first_layer = is_none ? 1 : static_cast<std::uint32_t>(first);
  element.last_layer = is_none ? 0 : static_cast<std::uint32_t>(last);
}

}  // namespace

template <int Dim>
std::optional<kernels::FarSphere> coarse_in_layers(const LayerGrid<Dim>& grid,
                                                   const exact::Elements<Dim>& coarse,
                                                   std::size_t k, std::uint32_t number) {
  const kernels::PositionMap& map = grid.map();
  kernels::FarSphere element{};
  element.number = number;
  set_size(map, coarse, k, element);
  if (!(element.radius < most_units)) return std::nullopt;
  std::array<double, Dim> position{};
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    position[axis] = (coarse[k].center[axis] - map.lower[axis]) * map.units_of_one;
    if (!(std::fabs(position[axis]) < most_units)) return std::nullopt;
    const double in_box = std::clamp(position[axis], 0.0, grid.end_of_positions());
    element.position[axis] = static_cast<std::int32_t>(in_box);
    element.beyond[axis] = static_cast<float>(position[axis] - element.position[axis]);
  }
  set_reach(grid, element);
  set_layers(grid, position[static_cast<std::size_t>(grid.layer_axis())], element);
  return element;
}

template <int Dim>
bool hold_squares_of(const LayerGrid<Dim>& grid, const exact::Elements<Dim>& coarse) {
  for (std::size_t k = 0; k < coarse.size(); ++k) {
    if (!coarse_in_layers(grid, coarse, k, 0)) return false;
  }
  return true;
}

template <int Dim>
bool hold_squares_of_visitors(const LayerGrid<Dim>& grid, double largest_radius) {
  // A box is two radii wide, and its lower corner as far from the grid's box, and the margin.
  return 4.0 * largest_radius * grid.map().units_of_one < 0.5 * most_units &&
         grid.margin() < 0.25 * most_units;
}

template bool hold_squares_of_visitors(const LayerGrid<2>&, double);
template bool hold_squares_of_visitors(const LayerGrid<3>&, double);
template bool hold_squares_of(const LayerGrid<2>&, const exact::Elements<2>&);
template bool hold_squares_of(const LayerGrid<3>&, const exact::Elements<3>&);
template std::optional<kernels::FarSphere> coarse_in_layers(const LayerGrid<2>&,
                                                            const exact::Elements<2>&, std::size_t,
                                                            std::uint32_t);
template std::optional<kernels::FarSphere> coarse_in_layers(const LayerGrid<3>&,
                                                            const exact::Elements<3>&, std::size_t,
                                                            std::uint32_t);

}  // namespace abut::engine
