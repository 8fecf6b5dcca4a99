#pragma once

#include "base/progress_reporter.hpp"
#include "engine/members.hpp"
#include "engine/search_set.hpp"
#include "engine/tiles/tiles.hpp"
#include "exact/elements.hpp"
#include "kernels/element_kernels.hpp"

#include <span>

namespace abut::engine {

/// Lists for what remains to be searched when a search set is divided by size, each pair in one of
/// them:
///
///   large    locals and halo elements of that size; the search set's coarse elements
///   small    the others; the search set's coarse elements and all large ones as coarse elements
///   across   small halo elements as locals, visited by large locals
struct SizeParts {
  Members& large;
  Members& small;
  Members& across;
};

/// The members of its lists.
struct SizeCounts {
  MemberCounts large;
  MemberCounts small;
  MemberCounts across;
};

template <int Dim>
[[nodiscard]] SizeCounts count_by_size(const exact::Elements<Dim>& elements,
                                       const SearchSet<Dim>& set, double cut,
                                       base::WorkCounter& work);

/// Fills lists that have so much room.
template <int Dim>
void divide_by_size(const exact::Elements<Dim>& elements, const SearchSet<Dim>& set, double cut,
                    const SizeParts& division, base::WorkCounter& work);

/// Own elements of a tile as locals, copies within a cell of their box as halo elements, coarse
/// elements that reach the box. The search set's lists are those of `members`, which have room for
/// all records and coarse elements of the tile.
template <int Dim>
[[nodiscard]] SearchSet<Dim> collect_tile(const exact::Elements<Dim>& elements,
                                          const Tiles<Dim>& tiles, std::size_t tile,
                                          double cell_size, double margin,
                                          const kernels::ElementKernels& kernels, Members& members,
                                          base::WorkCounter& work);

/// The search set of some members, with its bounds, but for coarse elements that are farther from
/// it than they reach and `wider`.
template <int Dim>
[[nodiscard]] SearchSet<Dim> search_set_of(const exact::Elements<Dim>& elements, Members& members,
                                           Wanted wanted, double wider,
                                           const kernels::ElementKernels& kernels,
                                           base::WorkCounter& work);

}  // namespace abut::engine
