#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "exact/sphere.hpp"
#include "kernels/image_kernels.hpp"
#include "lattice/ghost_window.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::periodic {

/// The periodic image of an element moved by `image` vectors of the sides of the orthogonal cell.
struct Ghost {
  std::uint32_t element;
  std::array<std::int32_t, 3> image;

  /// True if the image is lexicographically positive: its first number that is not 0 is positive.
  [[nodiscard]] bool is_positive() const noexcept { return image > std::array<std::int32_t, 3>{}; }
};

/// The images of locals that are ghosts. Those of small elements, positive ones only, that small
/// locals may reach; all those of large elements, of a radius of at least `cut`, that any local may
/// reach. So the few large elements do not make ghosts of all that they might reach.
template <int Dim>
struct GhostWindows {
  lattice::GhostWindow<Dim> of_small;
  lattice::GhostWindow<Dim> of_large;
  double cut;  ///< infinite: all are small

  GhostWindows(const lattice::ReducedLattice<Dim>& lattice,
               const lattice::OrthogonalCell<Dim>& orthogonal_cell,
               const lattice::CellExtent<Dim>& extent, const lattice::Reaches& reaches,
               double least_large, double unit)
      : of_small(lattice, orthogonal_cell, extent,
                 {std::min(reaches.largest_radius, least_large), reaches.margin, reaches.shape},
                 unit),
        of_large(lattice, orthogonal_cell, extent, reaches, unit),
        cut(least_large) {}

  /// Calls visit(first, last, numbers) as GhostWindow does.
  template <class Visit>
  void for_each_row(const exact::Sphere<Dim>& local, Visit&& visit) const {
    if (local.radius >= cut) return of_large.for_each_row(local, lattice::Shell::full, visit);
    of_small.for_each_row(local, lattice::Shell::half, visit);
  }
};

/// The number of ghosts for each local element from which on a reach is called long: it is about as
/// long as the cell or longer, and a local element is within reach of a good part of all ghosts, so
/// that no grid would help.
inline constexpr double ghosts_of_long_reach = 16.0;

/// True if locals would have more ghosts than that; stops counting there.
template <int Dim>
[[nodiscard]] bool is_long_reach(std::span<const exact::Sphere<Dim>> locals,
                                 const GhostWindows<Dim>& windows);

/// Locals and ghosts are numbered by 32 bits.
inline constexpr double most_locals_and_ghosts = 4294967294.0;

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
