#pragma once

#include "kernels/strided_spheres.hpp"

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// lattice::CellSides, of an orthogonal cell or an oblique one, and the vectors of the sides.
struct CellSideMap {
  std::size_t sides;
  double coefficients[3][3];  ///< of side, by axis
  double offset[3][3];
  double vectors[3][3];  ///< of side, by axis
  bool along[3];         ///< whether to wrap along this side
  bool pack;             ///< cells moved to words, periodic::MovedCells, else to triples
  double outer_below[3];
  double outer_from_radius;
};

/// lattice::CellSides::coordinate, of one element and by the operations of the vector kernels.
template <int Dim>
[[nodiscard]] inline double coordinate(const CellSideMap& map, std::size_t side,
                                       const double* center) {
  double sum = map.coefficients[side][0] * center[0];
  for (std::size_t axis = 1; axis < Dim; ++axis) sum += map.coefficients[side][axis] * center[axis];
  return sum;
}

/// Tells whether a coordinate is at most outer_below, or the radius at least outer_from_radius.
template <int Dim>
[[nodiscard]] inline bool is_outer(const CellSideMap& map, const exact::Sphere<Dim>& sphere) {
  bool outer = sphere.radius >= map.outer_from_radius;
  for (std::size_t k = 0; k < map.sides; ++k) {
    outer = outer || coordinate<Dim>(map, k, sphere.center) <= map.outer_below[k];
  }
  return outer;
}

/// Some of a block of elements or pairs, counted from its first one.
struct BlockList {
  /// Elements in a block: so few that they stay in the nearest cache.
  static constexpr std::size_t room = 512;

  std::uint32_t number[room + 8];  ///< and the lanes of the widest vector
  std::size_t count = 0;

  void push(std::size_t k) { number[count++] = static_cast<std::uint32_t>(k); }
};

/// The box of some centers.
struct CenterBounds {
  double lower[3];
  double upper[3];
};

/// How far a block of pairs was treated, and how many of these were kept.
struct KeptPairs {
  std::size_t treated;
  std::size_t kept;
};

/// Copies the pairs of a block that have a local element down to `to`, which may be where they are,
/// and lists those that have a ghost besides by their places there. Numbers from `locals` on are
/// those of ghosts; of no pair the first number is larger.
using KeepWithLocal = KeptPairs(const ContactPair* pairs, std::size_t count, std::uint32_t locals,
                                ContactPair* to, BlockList& with_ghost);

/// Passes over the elements of a periodic domain, in vectors. Each treats whole vectors from the
/// front and returns how many elements it treated; what is left is the caller's, who has the same
/// in plain C++ (so the level `scalar` treats none, and no level treats spheres whose numbers lie
/// too far apart).
struct ImageKernels {
  /// locals[k] = sphere first + k moved into the orthogonal cell, and by how many vectors: one word
  /// or three of `cells`. Widens the bounds, and lists those that are outer then, by k. Presupposes
  /// less than 2^31 cells.
  std::size_t (*wrap)(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                      int dimensions, const CellSideMap& map, double* locals, void* cells,
                      CenterBounds& bounds, BlockList& outer);

  /// Lists those of the spheres first + k that are outer, by k.
  std::size_t (*list_outer)(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                            int dimensions, const CellSideMap& map, BlockList& outer);

  /// Widens the bounds, by side, by the coordinates of the spheres first + k.
  std::size_t (*bound_sides)(const StridedSpheres& spheres, std::size_t first, std::size_t count,
                             int dimensions, const CellSideMap& map, CenterBounds& bounds);

  KeepWithLocal* keep_with_local;
};

/// `level` must be available.
[[nodiscard]] ImageKernels image_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] ImageKernels simd_image_kernels(std::int64_t target);
[[nodiscard]] KeepWithLocal* simd_keep_with_local(std::int64_t target);

}  // namespace abut::kernels
