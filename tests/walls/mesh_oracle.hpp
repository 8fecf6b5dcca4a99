#pragma once

#include <abut/domain.hpp>
#include <abut/image_shift.hpp>
#include <abut/mesh_contacts.hpp>

#include <gtest/gtest.h>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <vector>

/// Contacts of spheres with a mesh, without any of the library's arithmetic, search or numbering of
/// edges: each sphere against each triangle and each image of it in rational numbers.
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

/// A contact with the mesh moved by a shift.
struct MovedContact {
  MeshContact contact;
  ImageShift shift;

  friend auto operator<=>(const MovedContact&, const MovedContact&) = default;
  friend std::ostream& operator<<(std::ostream& out, const MovedContact& moved);
};

/// What the oracle is asked for beside balls and triangles.
struct MeshQuestion {
  Domain domain = Domain::open();
  double margin = 0.0;
  std::int32_t farthest = 0;  ///< images from -farthest to farthest along each periodic axis
  /// Whether a triangle is there for a ball; all are if this is empty.
  std::function<bool(std::size_t ball, std::size_t triangle)> allows = {};
  /// The images that may be within reach of a ball, where they are known; in place of `farthest`.
  std::function<std::vector<ImageShift>(std::size_t ball)> images = {};
};

/// Fails the test when a contact lies on the border of the images looked at, because others may lie
/// beyond.
[[nodiscard]] std::vector<MovedContact> oracle_mesh_contacts(const std::vector<Ball>& balls,
                                                             const MeshArrays& arrays,
                                                             const MeshQuestion& question);

/// Of the library; its options say that shifts are stored.
[[nodiscard]] std::vector<MovedContact> moved_contacts(const MeshContactList& list);

/// The same from every algorithm that supports the domain and several numbers of threads; returns
/// it. `options` without algorithm, threads, shifts.
[[nodiscard]] std::vector<MovedContact> agreed_contacts(const ElementView& spheres,
                                                        const TriangleMesh& mesh,
                                                        const Domain& domain, Options options = {});

}  // namespace abut::testing
