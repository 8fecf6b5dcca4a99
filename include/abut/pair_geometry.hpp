#pragma once

#include <abut/page_allocator.hpp>
#include <abut/quantity.hpp>

#include <array>
#include <span>
#include <vector>

namespace abut {

/// A point or a vector; in 2D its third number is 0.
using Vector = std::array<double, 3>;
/// Array of one number for each pair.
using NumberArray = std::vector<double, detail::PageAllocator<double>>;
/// Array of one point or vector for each pair.
using VectorArray = std::vector<Vector, detail::PageAllocator<Vector>>;

/// The caller's arrays for the quantities of pairs: one entry for each pair, or empty where a
/// quantity is not wanted.
struct PairGeometrySpans {
  std::span<double> gaps = {};       ///< see PairGeometry::gaps
  std::span<Vector> normals = {};    ///< see PairGeometry::normals
  std::span<Vector> points = {};     ///< see PairGeometry::points
  std::span<double> distances = {};  ///< see PairGeometry::distances
  std::span<Vector> vectors = {};    ///< see PairGeometry::vectors
};

/// Quantities of a list of pairs, in the order of the pairs; those that were not asked for are
/// empty. Element i is the pair's first one, element j its second one, moved by the image shift.
/// All have the same bits on every machine and with every number of threads.
struct PairGeometry {
  /// Gaps: distance − (r_i + r_j), with the bits of abut::gap.
  NumberArray gaps;

  /// Unit normals from i to j. Of spheres each component errs by at most one unit in the last place
  /// of the largest; coincident centers have the normal 0. Of boxes the normal lies along the axis
  /// of the largest separation (of equal ones the first), towards the side on which the center of j
  /// lies; it is 0 where the centers agree on that axis.
  VectorArray normals;

  /// Points of contact: of spheres the middle between their surfaces on the line of centers, of
  /// boxes the center of what they have in common. They lie beside element i, which is not moved.
  /// A component errs by at most one unit in the last place of the largest, or by 2^-94 of the
  /// largest number of the two elements where that is more.
  VectorArray points;

  /// Distances of the centers: of spheres the double nearest to the real distance, the smaller of
  /// two that are equally near; of boxes at most one unit in the last place off.
  NumberArray distances;

  /// Vectors x_j + n A − x_i between the centers, each component rounded once.
  VectorArray vectors;

  /// All arrays as the arrays of a caller.
  [[nodiscard]] PairGeometrySpans spans() noexcept {
    return {gaps, normals, points, distances, vectors};
  }
};

}  // namespace abut
