#pragma once

#include "base/progress_reporter.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <abut/neighbor_list.hpp>

#include <cstddef>
#include <span>

namespace abut::lists {

/// Rows of a neighbor list and the elements behind their numbers.
template <int Dim>
struct MeasuredRows {
  std::span<const exact::Sphere<Dim>> elements;
  std::span<const exact::Sphere<Dim>> others;  ///< what the neighbors' numbers mean
  exact::Lattice lattice;
  std::span<const PairCount> offsets;
  std::span<const ElementIndex> neighbors;
  std::span<const ImageShift> shifts;  ///< none: all zero
};

/// Fills distances and vectors, one for each neighbor; either may be empty.
template <int Dim>
void measure_neighbors(const MeasuredRows<Dim>& rows, std::span<double> distances,
                       std::span<NeighborList::Vector> vectors, std::size_t workers,
                       base::WorkCounter& work);

}  // namespace abut::lists
