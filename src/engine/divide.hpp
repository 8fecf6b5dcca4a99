#pragma once

#include "base/progress_reporter.hpp"
#include "engine/bench.hpp"
#include "engine/group.hpp"
#include "engine/tiles.hpp"
#include "exact/elements.hpp"
#include "kernels/element_kernels.hpp"

#include <span>

namespace abut::engine {

/// Divides a group by size at `cut`. What remains to be searched, each pair in one of them:
///
///   large    natives and foreigns of that size; the group's visitors
///   small    the others; the group's visitors and all large ones as visitors
///   across   small foreigns as natives, visited by large natives
template <int Dim>
void divide_by_size(const base::Elements<Dim>& elements, const Group<Dim>& group, double cut,
                    Floor<Dim>& floor, base::WorkCounter& work);

/// Own elements of a tile as natives, copies within a cell of their box as foreigns, visitors that
/// reach the box. The group's lists are those of `members`.
template <int Dim>
[[nodiscard]] Group<Dim> collect_tile(const base::Elements<Dim>& elements, const Tiles<Dim>& tiles,
                                      std::size_t tile, double cell_size, double margin,
                                      const kernels::ElementKernels& kernels, Members& members,
                                      base::WorkCounter& work);

/// The group of some members, with its bounds.
template <int Dim>
[[nodiscard]] Group<Dim> group_of(const base::Elements<Dim>& elements, const Members& members,
                                  Wanted wanted, const kernels::ElementKernels& kernels,
                                  base::WorkCounter& work);

}  // namespace abut::engine
