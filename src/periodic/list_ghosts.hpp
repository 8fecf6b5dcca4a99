#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "kernels/images/image_kernels.hpp"
#include "lattice/ghost_windows.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::periodic {

using lattice::Ghost;
using lattice::ghosts_of_long_reach;
template <int Dim>
using GhostWindows = lattice::GhostWindows<Dim>;

/// True if locals would have more ghosts than that; stops counting there.
template <int Dim>
[[nodiscard]] bool is_long_reach(const kernels::StridedSpheres& locals,
                                 const GhostWindows<Dim>& windows);

/// Throws Error{limit_exceeded} where there would be more.
template <int Dim>
void require_countable(const kernels::StridedSpheres& locals, const GhostWindows<Dim>& windows);

/// Some of the locals, that follow each other.
struct LocalBlock {
  const kernels::StridedSpheres& locals;
  std::size_t first;
  std::size_t count;  ///< at most BlockList::room
};

/// Lists those of a block that may have ghosts.
template <int Dim>
void list_outer(const LocalBlock& block, const kernels::CellSideMap& map,
                const kernels::ImageKernels& kernels, kernels::BlockList& outer);

/// Appends the ghosts of the outer ones of a block. Asks `progress`, if there is one, now and then.
template <int Dim>
void list_ghosts(const LocalBlock& block, const kernels::BlockList& outer,
                 const GhostWindows<Dim>& windows, base::Array<Ghost>& ghosts,
                 base::ProgressReporter* progress);

}  // namespace abut::periodic
