#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "kernels/image_kernels.hpp"
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
[[nodiscard]] bool is_long_reach(std::span<const exact::Sphere<Dim>> locals,
                                 const GhostWindows<Dim>& windows);

/// Throws Error{limit_exceeded} where there would be more.
template <int Dim>
void require_countable(std::span<const exact::Sphere<Dim>> locals,
                       const GhostWindows<Dim>& windows);

/// Lists those of a block of locals that may have ghosts.
template <int Dim>
void list_outer(std::span<const exact::Sphere<Dim>> locals, const kernels::OrthogonalCellMap& map,
                const kernels::ImageKernels& kernels, kernels::BlockList& outer);

/// Appends the ghosts of the outer ones of a block of locals, which are numbered from
/// `first_number` on. Asks `progress`, if there is one, now and then.
template <int Dim>
void list_ghosts(std::span<const exact::Sphere<Dim>> locals, const kernels::BlockList& outer,
                 std::size_t first_number, const GhostWindows<Dim>& windows,
                 base::Array<Ghost>& ghosts, base::ProgressReporter* progress);

}  // namespace abut::periodic
