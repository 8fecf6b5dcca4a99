#pragma once

#include <abut/mesh_contacts.hpp>

#include <array>
#include <vector>

/// Contacts of spheres with a mesh, without any of the library's arithmetic, search or numbering of
/// edges: each sphere against each triangle in rational numbers.
namespace abut::testing {

using Point = std::array<double, 3>;
using Cell = std::array<int, 3>;

/// A mesh as a caller has it.
struct MeshArrays {
  std::vector<Point> vertices;
  std::vector<Cell> triangles;

  [[nodiscard]] TriangleMesh mesh() const { return TriangleMesh(vertices, triangles); }
};

struct Ball {
  Point center;
  double radius;
};

[[nodiscard]] inline ElementView view_of(const std::vector<Ball>& balls) {
  const auto axis_of = [&](std::size_t axis) {
    return Column<double>{balls.empty() ? nullptr : &balls[0].center[axis], balls.size(),
                          sizeof(Ball)};
  };
  return spheres(axis_of(0), axis_of(1), axis_of(2), column(balls, &Ball::radius));
}

/// In the order of the library.
[[nodiscard]] std::vector<MeshContact> oracle_mesh_contacts(const std::vector<Ball>& balls,
                                                            const MeshArrays& arrays,
                                                            double margin = 0.0);

}  // namespace abut::testing
