#pragma once

#include "base/progress_reporter.hpp"
#include "engine/search_set.hpp"
#include "engine/tiles.hpp"
#include "engine/worker_scratch.hpp"
#include "exact/elements.hpp"
#include "kernels/element_kernels.hpp"

#include <span>

namespace abut::engine {

/// Divides a search set by size at `cut`. What remains to be searched, each pair in one of them:
///
///   large    locals and halo elements of that size; the search set's coarse elements
///   small    the others; the search set's coarse elements and all large ones as coarse elements
///   across   small halo elements as locals, visited by large locals
template <int Dim>
void divide_by_size(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set, double cut,
                    RecursionLevel<Dim>& level, base::WorkCounter& work);

/// Own elements of a tile as locals, copies within a cell of their box as halo elements, coarse
/// elements that reach the box. The search set's lists are those of `members`.
template <int Dim>
[[nodiscard]] SearchSet<Dim> collect_tile(const exact::Elements<Dim>& elements,
                                          const Tiles<Dim>& tiles, std::size_t tile,
                                          double cell_size, double margin,
                                          const kernels::ElementKernels& kernels, Members& members,
                                          base::WorkCounter& work);

/// The search set of some members, with its bounds.
template <int Dim>
[[nodiscard]] SearchSet<Dim> search_set_of(const exact::Elements<Dim>& elements,
                                           const Members& members, Wanted wanted,
                                           const kernels::ElementKernels& kernels,
                                           base::WorkCounter& work);

}  // namespace abut::engine
