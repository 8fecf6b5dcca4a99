#pragma once

#include "exact/box.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere_predicate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::exact {

/// Side of a point on each axis: on the lower bound (-1), on the upper one (1) or between them (0).
template <int Dim>
using BoxSides = std::array<std::int8_t, Dim>;

/// Returns, if the solid box lies within radius + margin of the center, the bounds on which its
/// point nearest to the center lies; both in real arithmetic. The nearest point has coordinates of
/// the center or of the corners, so that the contract of two spheres decides. Where a box is flat
/// its two bounds are one: the lower.
template <int Dim>
[[nodiscard]] inline std::optional<BoxSides<Dim>> sides_within_reach(
    const Sphere<Dim>& sphere, const Box<Dim>& box, double margin,
    std::uint64_t& exact_decisions) noexcept {
  Sphere<Dim> nearest{};
  BoxSides<Dim> sides{};
  for (int axis = 0; axis < Dim; ++axis) {
    const double x = std::clamp(sphere.center[axis], box.lower[axis], box.upper[axis]);
    nearest.center[axis] = x;
    sides[static_cast<std::size_t>(axis)] = x == box.lower[axis]   ? -1
                                            : x == box.upper[axis] ? 1
                                                                   : 0;
  }
  if (!within_reach(sphere, nearest, margin, exact_decisions)) return std::nullopt;
  return sides;
}

/// The bounds on which the point of a moved box lies that is nearest to the center, however far
/// away it is. Adds one to `doubts` for each axis on which a filter cannot tell.
template <int Dim>
[[nodiscard]] BoxSides<Dim> nearest_sides(const Sphere<Dim>& sphere, const Box<Dim>& box,
                                          const LatticeSteps<Dim>& steps,
                                          std::uint64_t& doubts) noexcept;

/// A sphere outside a box and the corner of the box that lies on the given sides, with all that has
/// axes without those on which the center lies between the bounds: these do not count in the
/// distance.
template <int Dim>
struct SideCorner {
  SideCorner(const Sphere<Dim>& sphere, const Box<Dim>& box, const BoxSides<Dim>& sides,
             const Lattice& given) noexcept;

  Sphere<Dim> center;
  Sphere<Dim> nearest;
  Lattice lattice;
};

/// Returns these bounds, if the box moved by the shift n of a lattice A is within reach. On each
/// axis it is decided exactly on which side of the bounds + n A the center lies; the distance is
/// that to the bounds of those axes where it does not lie between them, by the contract of two
/// spheres with a lattice.
template <int Dim>
[[nodiscard]] std::optional<BoxSides<Dim>> sides_within_reach(
    const Sphere<Dim>& sphere, const Box<Dim>& box, const ImageShift& shift, const Lattice& lattice,
    double margin, std::uint64_t& exact_decisions) noexcept;

}  // namespace abut::exact
