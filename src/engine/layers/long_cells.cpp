#include "engine/layers/long_cells.hpp"

#include <cstddef>

namespace abut::engine {

template <int Dim>
double joined_in_runs(const LayerGrid<Dim>& grid, SampleSize size, OccupancySample<Dim>& sample) {
  return 2.0 * (sample.mean_occupancy(PiecesOfRows<Dim>{grid}, size) - 1.0);
}

template <int Dim>
std::optional<LayerGrid<Dim>> choose_long_cells(const grid::Bounds<Dim>& bounds, double margin,
                                                double least_cell, OccupancySample<Dim>& sample) {
  std::optional<LayerGrid<Dim>> best;
  double least = 0.0;
  const auto attempt = [&](const LongCells& shape) {
    const auto grid =
        LayerGrid<Dim>::of_long_cells(bounds, margin, least_cell, sample.elements(), shape);
    if (!grid) return;
    const double joined = joined_in_runs(*grid, SampleSize::small, sample);
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

template double joined_in_runs(const LayerGrid<2>&, SampleSize, OccupancySample<2>&);
template double joined_in_runs(const LayerGrid<3>&, SampleSize, OccupancySample<3>&);
template std::optional<LayerGrid<2>> choose_long_cells(const grid::Bounds<2>&, double, double,
                                                       OccupancySample<2>&);
template std::optional<LayerGrid<3>> choose_long_cells(const grid::Bounds<3>&, double, double,
                                                       OccupancySample<3>&);

}  // namespace abut::engine
