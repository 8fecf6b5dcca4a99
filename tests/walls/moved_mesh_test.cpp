// Meshes that move: what the vertices become, and what is refused.

#include "support/error_expectations.hpp"
#include "walls/mesh_scenes.hpp"

#include <abut/abut.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace abut::testing {
namespace {

using scenes::Random;

TEST(MovedMesh, HasTheVerticesOfTheFixedSequence) {
  Random random(1711);
  MeshArrays arrays = cube();
  std::vector<Ball> none;
  shake(arrays, none, random);
  TriangleMesh mesh = arrays.mesh();
  for (int step = 0; step < 3; ++step) {
    Motion motion;
    for (auto& row : motion.rotation) {
      for (double& x : row) x = random.uniform(-1.0, 1.0);
    }
    for (double& x : motion.translation) x = random.uniform(-1.0, 1.0);
    mesh.move(motion);
    EXPECT_EQ(mesh.motion(), motion);
    for (std::size_t k = 0; k < arrays.vertices.size(); ++k) {
      const Point& v = arrays.vertices[k];
      EXPECT_EQ(mesh.rest_vertices()[k], v);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& r = motion.rotation[axis];
        const double first = r[0] * v[0], second = r[1] * v[1], third = r[2] * v[2];
        const double sum = first + second;
        EXPECT_EQ(mesh.vertices()[k][axis], (sum + third) + motion.translation[axis]);
      }
    }
  }
}

/// Contacts, boxes and numbers are those of a mesh that is made of the moved vertices.
TEST(MovedMesh, IsTheMeshOfItsVertices) {
  Random random(1712);
  MeshArrays arrays = soup(random, 12, 20, 4);
  TriangleMesh mesh = arrays.mesh();
  mesh.move({{{{0.6, -0.8, 0.0}, {0.8, 0.6, 0.0}, {0.0, 0.0, 1.0}}}, {0.1, 0.2, 0.3}});
  MeshArrays there = arrays;
  there.vertices.assign(mesh.vertices().begin(), mesh.vertices().end());
  const std::vector<Ball> balls = balls_in(random, 60, 4);
  const MeshContactList found = find_mesh_contacts(view_of(balls), mesh);
  const MeshContactList expected = find_mesh_contacts(view_of(balls), there.mesh());
  ASSERT_GT(expected.size(), 10U);
  EXPECT_TRUE(std::ranges::equal(found.contacts(), expected.contacts()));
  mesh.deform(arrays.vertices);
  EXPECT_EQ(mesh.motion(), Motion{});
  EXPECT_TRUE(std::ranges::equal(find_mesh_contacts(view_of(balls), mesh).contacts(),
                                 find_mesh_contacts(view_of(balls), arrays.mesh()).contacts()));
}

TEST(MovedMesh, RefusesWhatCannotBe) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const MeshArrays arrays = cube();
  TriangleMesh mesh = arrays.mesh();
  Motion motion;
  motion.translation[1] = infinite;
  expect_error(ErrorCode::invalid_input, {"motion"}, [&] { mesh.move(motion); });
  motion.translation[1] = 1e308;
  motion.rotation[1][1] = 1e308;
  expect_error(ErrorCode::invalid_input, {"vertex 3", "y = inf"}, [&] { mesh.move(motion); });
  EXPECT_EQ(mesh.motion(), Motion{});
  EXPECT_EQ(mesh.vertices()[3], arrays.vertices[3]);
  std::vector<Point> vertices = arrays.vertices;
  vertices[2][0] = infinite;
  expect_error(ErrorCode::invalid_input, {"vertex 2", "x = inf"}, [&] { mesh.deform(vertices); });
  vertices.pop_back();
  expect_error(ErrorCode::wrong_usage, {"8 vertices"}, [&] { mesh.deform(vertices); });
}

TEST(MovedMesh, StaysJoined) {
  // A square as a file lists it: each triangle with its own corners.
  const std::vector<Point> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                   {0, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const std::vector<Cell> triangles{{0, 1, 2}, {3, 4, 5}};
  TriangleMesh mesh = TriangleMesh::joined(corners, triangles);
  mesh.move({{{{0.0, -1.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}}, {}});
  const std::vector<Ball> balls{{{-0.5, 0.5, 0.5}, 1.0}};
  EXPECT_EQ(find_mesh_contacts(view_of(balls), mesh).size(), 1U);
  std::vector<Point> torn = corners;
  torn[3][2] = 0.5;
  expect_error(ErrorCode::invalid_input, {"vertex 3", "vertex 0"}, [&] { mesh.deform(torn); });
  torn[0][2] = 0.5;
  mesh.deform(torn);
  EXPECT_EQ(mesh.vertices()[3][2], 0.5);
  const Domain cell = Domain::periodic({1.0, 1.0, unbounded});
  TriangleMesh floor = TriangleMesh::joined(corners, triangles, cell);
  expect_error(ErrorCode::wrong_usage, {"joined across"}, [&] { floor.move({}); });
  expect_error(ErrorCode::wrong_usage, {"joined across"}, [&] { floor.deform(corners); });
}

}  // namespace
}  // namespace abut::testing
