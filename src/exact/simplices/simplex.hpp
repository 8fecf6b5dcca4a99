#pragma once

#include "exact/simplices/point.hpp"

#include <array>
#include <cstddef>

namespace abut::exact {

/// The convex hull of its vertices: a point, a segment, a triangle or, in space, a tetrahedron.
/// Vertices may coincide, lie on a line or in a plane.
template <int Dim>
struct Simplex {
  static constexpr std::size_t most_vertices = Dim + 1;

  std::array<Point<Dim>, most_vertices> vertices;
  std::size_t size;  ///< number of vertices, at least 1; the others mean nothing
};

}  // namespace abut::exact
