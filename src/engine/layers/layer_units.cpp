#include "engine/layers/layer_units.hpp"

#include "kernels/layers/layer_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace abut::engine {
namespace {

/// A position has 31 bits: with one for its cell, an axis has two of these.
constexpr int most_bits_of_cell = 30;

}  // namespace

template <int Dim>
double longest_axis(const grid::Bounds<Dim>& bounds) {
  double longest = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    longest = std::max(longest, bounds.upper[axis] - bounds.lower[axis]);
  }
  return longest;
}

template <int Dim>
std::array<std::size_t, Dim> axes_by_extent(const grid::Bounds<Dim>& bounds) {
  std::array<std::size_t, Dim> axes{};
  std::iota(axes.begin(), axes.end(), std::size_t{0});
  const auto extent = [&](std::size_t axis) { return bounds.upper[axis] - bounds.lower[axis]; };
  std::sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return extent(a) != extent(b) ? extent(a) < extent(b) : a < b;
  });
  return axes;
}

template <int Dim>
LayerUnits units_for(const grid::Bounds<Dim>& bounds, double cell, double least) {
  const double longest = longest_axis(bounds);
  int wider = 0;
  for (double half = 0.5 * cell; half >= least && wider < most_bits_of_cell; half *= 0.5) ++wider;
  int shift = std::min(kernels::most_cell_bits + wider, most_bits_of_cell);
  int reach_bits = 0;
  for (; shift >= kernels::least_cell_bits; --shift) {
    reach_bits = std::min(std::max(shift - wider, kernels::cell_bits), shift);
    const double end = kernels::end_of_positions(reach_bits);
    if (longest * (std::ldexp(1.0, shift) / cell) < end) break;
  }
  return {std::max(shift, kernels::least_cell_bits), reach_bits};
}

template double longest_axis(const grid::Bounds<2>&);
template double longest_axis(const grid::Bounds<3>&);
template std::array<std::size_t, 2> axes_by_extent<2>(const grid::Bounds<2>&);
template std::array<std::size_t, 3> axes_by_extent<3>(const grid::Bounds<3>&);
template LayerUnits units_for(const grid::Bounds<2>&, double, double);
template LayerUnits units_for(const grid::Bounds<3>&, double, double);

}  // namespace abut::engine
