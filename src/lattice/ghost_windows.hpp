#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"
#include "lattice/ghost_window.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace abut::lattice {

/// The periodic image of an element moved by `image` vectors of the sides of a cell.
template <class Number>
struct GhostOf {
  std::make_unsigned_t<Number> element;  ///< as wide as the others: a copy has no byte unwritten
  std::array<Number, 3> image;

  /// True if the image is lexicographically positive: its first number that is not 0 is positive.
  [[nodiscard]] ABUT_HD bool is_positive() const noexcept {
    if (image[0] != 0) return image[0] > 0;
    if (image[1] != 0) return image[1] > 0;
    return image[2] > 0;
  }
};
using Ghost = GhostOf<std::int32_t>;

/// The number of ghosts for each local element from which on a reach is called long: it is about as
/// long as the cell or longer, and a local element is within reach of a good part of all ghosts, so
/// that no grid would help.
inline constexpr double ghosts_of_long_reach = 16.0;

/// Locals and ghosts are numbered by 32 bits.
inline constexpr double most_locals_and_ghosts = 4294967294.0;

/// The images of locals that are ghosts. Those of small elements, positive ones only, that small
/// locals may reach; all those of large elements, of a radius of at least `cut`, that any local may
/// reach. So the few large elements do not make ghosts of all that they might reach.
template <int Dim>
struct GhostWindows {
  GhostWindow<Dim> of_small;
  GhostWindow<Dim> of_large;
  double cut;  ///< infinite: all are small

  GhostWindows(const ReducedLattice<Dim>& lattice, const CellSides<Dim>& cell,
               const CellExtent<Dim>& extent, const Reaches& reaches, double least_large,
               double unit)
      : of_small(lattice, cell, extent,
                 {std::min(reaches.largest_radius, least_large), reaches.margin, reaches.shape},
                 unit),
        of_large(lattice, cell, extent, reaches, unit),
        cut(least_large) {}

  /// Calls visit(first, last, numbers) as GhostWindow does.
  template <class Visit>
  ABUT_HD void for_each_row(const exact::Sphere<Dim>& local, Visit&& visit) const {
    if (local.radius >= cut) return of_large.for_each_row(local, Shell::full, visit);
    of_small.for_each_row(local, Shell::half, visit);
  }
};

}  // namespace abut::lattice
