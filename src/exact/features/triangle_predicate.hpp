#pragma once

#include "exact/lattice.hpp"
#include "exact/sphere_predicate.hpp"

#include <cstdint>
#include <optional>

namespace abut::exact {

/// A triangle of finite numbers. Corners may coincide or lie on a line.
struct Triangle {
  double corner[3][3];
};

/// The parts of a triangle: corners, sides without their ends, the face without its sides.
enum class TrianglePart : std::uint8_t {
  corner_0,
  corner_1,
  corner_2,
  side_01,
  side_02,
  side_12,
  face,
};

/// The part of the triangle, if that lies within radius + margin of the center, that holds the
/// point nearest to the center; both in real arithmetic. A triangle is convex, so that there is one
/// such point. Where corners coincide or lie on a line it may be in several parts: then the first
/// of these in the order of TrianglePart. Adds one to `exact_decisions` when the filter cannot
/// decide.
[[nodiscard]] std::optional<TrianglePart> part_within_reach(
    const Sphere<3>& sphere, const Triangle& triangle, double margin,
    std::uint64_t& exact_decisions) noexcept;

/// Returns that part with the triangle moved by the shift n of a lattice A, that is, of the corners
/// + n A.
[[nodiscard]] std::optional<TrianglePart> part_within_reach(
    const Sphere<3>& sphere, const Triangle& triangle, const ImageShift& shift,
    const Lattice& lattice, double margin, std::uint64_t& exact_decisions) noexcept;

/// The part of the triangle, moved by a shift, that holds the point nearest to the center, however
/// far away it is.
[[nodiscard]] TrianglePart nearest_part_of(const Sphere<3>& sphere, const Triangle& triangle,
                                           const LatticeSteps<3>& steps) noexcept;

/// Returns the nearest part by long integers alone.
[[nodiscard]] TrianglePart nearest_part_exactly(const Sphere<3>& sphere, const Triangle& triangle,
                                                const LatticeSteps<3>& steps) noexcept;

/// The parts within reach by long integers alone. Needs the default floating-point environment, as
/// all here.
[[nodiscard]] std::optional<TrianglePart> part_within_reach_exactly(const Sphere<3>& sphere,
                                                                    const Triangle& triangle,
                                                                    double margin) noexcept;
[[nodiscard]] std::optional<TrianglePart> part_within_reach_exactly(const Sphere<3>& sphere,
                                                                    const Triangle& triangle,
                                                                    const LatticeSteps<3>& steps,
                                                                    double margin) noexcept;

}  // namespace abut::exact
