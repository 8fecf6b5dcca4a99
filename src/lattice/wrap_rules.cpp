#include "lattice/wrap_rules.hpp"

#include <algorithm>

namespace abut::lattice {

template <int Dim>
std::array<double, Dim> most_cells_moved(const CellSides<Dim>& cell, const CellExtent<Dim>& extent,
                                         const AlongSides<Dim>& along) noexcept {
  std::array<double, Dim> cells{};
  for (std::size_t k = 0; k < cell.count; ++k) {
    if (!along[k]) continue;
    cells[k] = cell.magnitude(k, extent.farthest) + 2.0 + moved_along_earlier_sides(cell, k, cells);
  }
  return cells;
}

template <int Dim>
AlongSides<Dim> sides_to_wrap(const CellSides<Dim>& cell, const CellExtent<Dim>& extent,
                              const GhostWindow<Dim>& window) noexcept {
  constexpr double far = 0.0625;
  AlongSides<Dim> along{};
  std::array<double, Dim> cells{};
  for (std::size_t k = 0; k < cell.count; ++k) {
    const double moved = moved_along_earlier_sides(cell, k, cells);
    const double magnitude = cell.magnitude(k, extent.farthest);
    const double spread = extent.upper[k] - extent.lower[k] + 2.0 * moved;
    along[k] = !std::isfinite(magnitude) || moved > far ||
               !(spread <= 1.0 + 0.25 * std::min(window.widest(k), 1.0));
    if (along[k]) cells[k] = magnitude + 2.0 + moved;
  }
  const bool any = std::find(along.begin(), along.end(), true) != along.end();
  if (any && !is_in_range<Dim>(cell, extent, window)) along.fill(true);
  return along;
}

template <int Dim>
bool is_in_range(const CellSides<Dim>& cell, const CellExtent<Dim>& extent,
                 const GhostWindow<Dim>& window) noexcept {
  AlongSides<Dim> all{};
  all.fill(true);
  const std::array<double, Dim> cells = most_cells_moved<Dim>(cell, extent, all);
  bool in_range = true;
  for (std::size_t k = 0; k < cell.count; ++k) {
    in_range = in_range && cells[k] <= 0x1p30 && window.widest(k) <= 0x1p30;
  }
  return in_range;
}

template <int Dim>
SideSteps<Dim> side_steps(const ReducedLattice<Dim>& lattice, const CellSides<Dim>& cell,
                          double unit) noexcept {
  SideSteps<Dim> steps{};
  for (std::size_t k = 0; k < cell.count; ++k) {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      steps[k][axis] = lattice.vectors[cell.vector_of[k]][axis] * unit;
    }
  }
  return steps;
}

template <int Dim>
double magnitude_of(const CellExtent<Dim>& extent, const GhostWindow<Dim>& window,
                    const AlongSides<Dim>& along, const SideSteps<Dim>& steps,
                    double width) noexcept {
  double magnitude = 0.0;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    double moved = 0.0;
    for (std::size_t k = 0; k < window.sides(); ++k) {
      const double cells = std::max(window.most_cells(k), along[k] ? 1.0 : 0.0);
      moved += cells * std::fabs(steps[k][axis]);
    }
    if (moved > 0.0) magnitude += extent.farthest[axis] + moved + width;
  }
  return magnitude;
}

template <int Dim>
std::array<double, 3> most_shifts(const ReducedLattice<Dim>& lattice, const CellSides<Dim>& cell,
                                  const GhostWindow<Dim>& window,
                                  const std::array<double, Dim>& cells_moved_at_most) noexcept {
  std::array<double, 3> shift{};
  for (std::size_t k = 0; k < lattice.count; ++k) {
    const std::size_t vector = cell.vector_of[k];
    for (std::size_t l = 0; l < lattice.count; ++l) {
      shift[l] += (window.most_cells(k) + 2.0 * cells_moved_at_most[k]) *
                  std::fabs(static_cast<double>(lattice.to_given[vector][l]));
    }
  }
  return shift;
}

template std::array<double, 2> most_cells_moved<2>(const CellSides<2>&, const CellExtent<2>&,
                                                   const AlongSides<2>&) noexcept;
template AlongSides<2> sides_to_wrap<2>(const CellSides<2>&, const CellExtent<2>&,
                                        const GhostWindow<2>&) noexcept;
template bool is_in_range<2>(const CellSides<2>&, const CellExtent<2>&,
                             const GhostWindow<2>&) noexcept;
template SideSteps<2> side_steps<2>(const ReducedLattice<2>&, const CellSides<2>&, double) noexcept;
template double magnitude_of<2>(const CellExtent<2>&, const GhostWindow<2>&, const AlongSides<2>&,
                                const SideSteps<2>&, double) noexcept;
template std::array<double, 3> most_shifts<2>(const ReducedLattice<2>&, const CellSides<2>&,
                                              const GhostWindow<2>&,
                                              const std::array<double, 2>&) noexcept;

template std::array<double, 3> most_cells_moved<3>(const CellSides<3>&, const CellExtent<3>&,
                                                   const AlongSides<3>&) noexcept;
template AlongSides<3> sides_to_wrap<3>(const CellSides<3>&, const CellExtent<3>&,
                                        const GhostWindow<3>&) noexcept;
template bool is_in_range<3>(const CellSides<3>&, const CellExtent<3>&,
                             const GhostWindow<3>&) noexcept;
template SideSteps<3> side_steps<3>(const ReducedLattice<3>&, const CellSides<3>&, double) noexcept;
template double magnitude_of<3>(const CellExtent<3>&, const GhostWindow<3>&, const AlongSides<3>&,
                                const SideSteps<3>&, double) noexcept;
template std::array<double, 3> most_shifts<3>(const ReducedLattice<3>&, const CellSides<3>&,
                                              const GhostWindow<3>&,
                                              const std::array<double, 3>&) noexcept;

}  // namespace abut::lattice
