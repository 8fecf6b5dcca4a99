#pragma once

#include "engine/sizes/size_classes.hpp"
#include "grid/bounds.hpp"

namespace abut::engine {

/// A size of cells for layers in which elements look for smaller ones, and what the search is
/// estimated to cost.
struct CellBySize {
  double cell;  ///< 0 where all elements stand in one place
  double cost;  ///< in candidate tests, as that of SizePlan
};

/// Returns the size, of several densities that are tried, that costs least.
template <int Dim>
[[nodiscard]] CellBySize choose_cell_by_size(const SizeClasses& classes,
                                             const SizeDistribution& sizes,
                                             const grid::Bounds<Dim>& bounds);

}  // namespace abut::engine
