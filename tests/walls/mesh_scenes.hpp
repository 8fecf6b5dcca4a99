#pragma once

#include "scenes/random.hpp"
#include "walls/mesh_oracle.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

/// Meshes and balls for tests.
namespace abut::testing {

/// A square of so many cells a side in the plane z = 0, with diagonals in both directions.
[[nodiscard]] inline MeshArrays flat_grid(int side) {
  MeshArrays grid;
  for (int y = 0; y <= side; ++y) {
    for (int x = 0; x <= side; ++x) {
      grid.vertices.push_back({static_cast<double>(x), static_cast<double>(y), 0.0});
    }
  }
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const int a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
      if ((x + y) % 2 == 0) {
        grid.triangles.insert(grid.triangles.end(), {{a, b, d}, {d, c, a}});
      } else {
        grid.triangles.insert(grid.triangles.end(), {{a, b, c}, {b, d, c}});
      }
    }
  }
  return grid;
}

/// The surface of the cube from -1 to 1.
[[nodiscard]] inline MeshArrays cube() {
  MeshArrays result;
  for (int k = 0; k < 8; ++k) {
    result.vertices.push_back({k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0});
  }
  for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
           {0, 1, 2, 3}, {4, 5, 6, 7}, {0, 1, 4, 5}, {2, 3, 6, 7}, {0, 2, 4, 6}, {1, 3, 5, 7}}) {
    result.triangles.push_back({a, b, d});
    result.triangles.push_back({d, c, a});
  }
  return result;
}

/// Triangles of few whole numbers: without area, repeated, crossing, three on an edge.
[[nodiscard]] inline MeshArrays soup(scenes::Random& random, std::size_t vertices,
                                     std::size_t triangles, int most) {
  MeshArrays result;
  const auto range = static_cast<std::size_t>(most) + 1;
  for (std::size_t k = 0; k < vertices; ++k) {
    Point point{};
    for (double& x : point) x = static_cast<double>(random.below(range));
    result.vertices.push_back(point);
  }
  for (std::size_t k = 0; k < triangles; ++k) {
    Cell cell{};
    for (int& vertex : cell) vertex = static_cast<int>(random.below(vertices));
    result.triangles.push_back(cell);
  }
  return result;
}

[[nodiscard]] inline std::vector<Ball> balls_in(scenes::Random& random, std::size_t count,
                                                int most) {
  std::vector<Ball> balls;
  const auto halves = static_cast<std::size_t>(2 * most) + 5;
  for (std::size_t k = 0; k < count; ++k) {
    Ball ball{{}, static_cast<double>(random.below(5)) * 0.5};
    for (double& x : ball.center) x = static_cast<double>(random.below(halves)) * 0.5 - 1.0;
    balls.push_back(ball);
  }
  return balls;
}

/// Moves each vertex and each center a little, to numbers of all bits.
inline void shake(MeshArrays& arrays, std::vector<Ball>& balls, scenes::Random& random) {
  for (Point& vertex : arrays.vertices) {
    for (double& x : vertex) x += random.uniform(-0.3, 0.3);
  }
  for (Ball& ball : balls) {
    for (double& x : ball.center) x += random.uniform(-0.3, 0.3);
    ball.radius *= random.uniform(0.8, 1.2);
  }
}

/// How many contacts are with features of that kind.
[[nodiscard]] inline std::size_t count_of(const std::vector<MovedContact>& contacts,
                                          FeatureKind kind) {
  return static_cast<std::size_t>(
      std::count_if(contacts.begin(), contacts.end(),
                    [&](const MovedContact& moved) { return moved.contact.feature.kind == kind; }));
}

}  // namespace abut::testing
