#pragma once

#include "engine/layers/layer_grid.hpp"
#include "engine/layers/layer_spheres.hpp"
#include "engine/layers/occupancy_sample.hpp"
#include "grid/bounds.hpp"

#include <optional>

namespace abut::engine {

/// Returns the grid of long cells over the box of some spheres in whose runs they crowd least, as
/// far as a small sample tells, if there is one. Elements on a surface fill few of many cubes, so
/// that these must be wide, but most of as many rods.
template <int Dim>
[[nodiscard]] std::optional<LayerGrid<Dim>> choose_long_cells(const grid::Bounds<Dim>& bounds,
                                                              double margin, double least_cell,
                                                              OccupancySample<Dim>& sample);

/// Estimates how many elements two runs of another one have, whatever the shape of cells.
template <int Dim>
[[nodiscard]] double joined_in_runs(const LayerGrid<Dim>& grid, SampleSize size,
                                    OccupancySample<Dim>& sample);

}  // namespace abut::engine
