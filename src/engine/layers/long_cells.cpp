#include "engine/layers/long_cells.hpp"

#include <cstddef>

namespace abut::engine {

template <int Dim>
double joined_in_runs(const LayerGrid<Dim>& grid, const LayerSpheres<Dim>& spheres, SampleSize size,
                      OccupancySample& sample) {
  return 2.0 * (sample.mean_occupancy(PiecesOfRows<Dim>{grid}, spheres, size) - 1.0);
}

template <int Dim>
std::optional<LayerGrid<Dim>> choose_long_cells(const grid::Bounds<Dim>& bounds, double margin,
                                                double least_cell, const LayerSpheres<Dim>& spheres,
                                                OccupancySample& sample) {
  std::optional<LayerGrid<Dim>> best;
  double least = 0.0;
  const auto attempt = [&](const LongCells& shape) {
    const auto grid =
        LayerGrid<Dim>::of_long_cells(bounds, margin, least_cell, spheres.count_in_layers(), shape);
    if (!grid) return;
    const double joined = joined_in_runs(*grid, spheres, SampleSize::small, sample);
    if (best && joined >= least) return;
    best = grid;
    least = joined;
  };
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    attempt({axis, LongCells::Along::rows});
    if constexpr (Dim == 3) attempt({axis, LongCells::Along::next_rows});
  }
  return best;
}

template double joined_in_runs(const LayerGrid<2>&, const LayerSpheres<2>&, SampleSize,
                               OccupancySample&);
template double joined_in_runs(const LayerGrid<3>&, const LayerSpheres<3>&, SampleSize,
                               OccupancySample&);
template std::optional<LayerGrid<2>> choose_long_cells(const grid::Bounds<2>&, double, double,
                                                       const LayerSpheres<2>&, OccupancySample&);
template std::optional<LayerGrid<3>> choose_long_cells(const grid::Bounds<3>&, double, double,
                                                       const LayerSpheres<3>&, OccupancySample&);

}  // namespace abut::engine
