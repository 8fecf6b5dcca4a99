#include "engine/layers/cell_by_size.hpp"

#include "exact/numbers/cube_root.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

namespace abut::engine {
namespace {

/// Costs in units of a candidate test in tiles, some 2.25 instructions: to bring an element into
/// layers, the two vectors of a near element, those again of one whose runs are too long for them,
/// any other element, a row in which it looks, and a candidate there. Set by instructions counted
/// with valgrind and by the times of docs/adr/0024-sizes-in-layers.md.
constexpr double cost_of_element = 75.0;
constexpr double cost_of_near = 80.0;
constexpr double cost_of_long_runs = 70.0;
constexpr double cost_of_other = 60.0;
constexpr double cost_of_row = 32.0;
constexpr double cost_of_test = 2.5;

/// Lanes of a vector, which two rows of a layer share; runs differ in length.
constexpr double lanes = 8.0;
constexpr double few_in_lanes = 3.0;

/// Columns are a quarter of a cell wide.
constexpr double column = 0.25;

/// The elements in a cell that are tried.
constexpr std::array densities = {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};

/// The mean radius of a class to its upper end.
constexpr double mean_of_class = 0.85;

/// The part of a box that a ball in it cuts where cells are small.
constexpr double part_of_box = 0.7;

template <int Dim>
constexpr double rows_of(double wide) {
  return Dim == 2 ? wide : wide * wide;
}

/// Cost of an element that looks that many cells around it, in cells that hold so many.
template <int Dim>
double cost_of(double reach, double density, double count) {
  const double along = std::min(2.0 * reach + column, count);
  const double rows = rows_of<Dim>(2.0 * reach + 1.0);
  if (reach < 0.5) {
    const double in_lanes = density * along * (2.0 * reach + 1.0);
    const double are_long = std::clamp((in_lanes - few_in_lanes) / lanes, 0.0, 1.0);
    return cost_of_near + cost_of_long_runs * are_long;
  }
  const double part = reach < 1.0 ? 1.0 : part_of_box;
  const double cut = std::min(part * rows, count);
  const double tests = std::min(part * rows * density * along, count);
  return cost_of_other + cost_of_row * cut + cost_of_test * tests;
}

/// Returns the side of cells of which a box has so many, where an axis shorter than a cell counts
/// as one; 0 for a point. The order of pairs follows from it: roots have the same bits everywhere.
template <int Dim>
double side_of_cells(const grid::Bounds<Dim>& bounds, double cells) {
  std::array<double, Dim> extents{};
  for (std::size_t k = 0; k < Dim; ++k) extents[k] = bounds.upper[k] - bounds.lower[k];
  std::sort(extents.begin(), extents.end(), std::greater<>());
  // The longest axes, as long as each of them has a cell.
  double product = 1.0;
  double side = 0.0;
  for (std::size_t k = 0; k < Dim && extents[k] > 0.0; ++k) {
    product *= extents[k] / extents[0];
    const int axes = static_cast<int>(k) + 1;
    const double next = extents[0] * exact::side_of(product / cells, axes);
    if (k > 0 && next > extents[k]) break;
    side = next;
  }
  return side;
}

}  // namespace

template <int Dim>
CellBySize choose_cell_by_size(const SizeClasses& classes, const SizeDistribution& sizes,
                               const grid::Bounds<Dim>& bounds) {
  double count = 0.0;
  for (const SizeClass& one : classes) count += one.count;
  CellBySize best{0.0, 0.0};
  for (const double density : densities) {
    const double cell = side_of_cells<Dim>(bounds, count / density);
    if (!(cell > 0.0)) return best;
    double cost = cost_of_element * count;
    for (const SizeClass& one : classes) {
      const double own_reach = 2.0 * mean_of_class * one.radius * sizes.reach() + sizes.margin;
      cost += one.count * cost_of<Dim>(own_reach / cell, density, count);
    }
    if (best.cell == 0.0 || cost < best.cost) best = {cell, cost};
  }
  return best;
}

template CellBySize choose_cell_by_size<2>(const SizeClasses&, const SizeDistribution&,
                                           const grid::Bounds<2>&);
template CellBySize choose_cell_by_size<3>(const SizeClasses&, const SizeDistribution&,
                                           const grid::Bounds<3>&);

}  // namespace abut::engine
