#include "api/mesh_oracle.hpp"

#include "base/triangle_oracle.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace abut::testing {
namespace {

using base::TrianglePart;

/// A feature by its vertices: one, two or three.
using VertexSet = std::set<int>;

/// With its corners by ascending number, the nearest part of several is that of smallest numbers.
VertexSet nearest_feature(const Ball& ball, const MeshArrays& arrays, Cell cell, double margin) {
  std::sort(cell.begin(), cell.end());
  base::Triangle triangle{};
  base::Sphere<3> sphere{{}, ball.radius};
  std::copy(ball.center.begin(), ball.center.end(), sphere.center);
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& vertex = arrays.vertices[static_cast<std::size_t>(cell[k])];
    std::copy(vertex.begin(), vertex.end(), triangle.corner[k]);
  }
  const auto part = test::part_within_reach_by_rationals(sphere, triangle, margin);
  if (!part) return {};
  switch (*part) {
    case TrianglePart::corner_0:
    case TrianglePart::corner_1:
    case TrianglePart::corner_2:
      return {cell[static_cast<std::size_t>(*part)]};
    case TrianglePart::side_01:
      return {cell[0], cell[1]};
    case TrianglePart::side_02:
      return {cell[0], cell[2]};
    case TrianglePart::side_12:
      return {cell[1], cell[2]};
    case TrianglePart::face:
      break;
  }
  return {cell[0], cell[1], cell[2]};
}

bool has(const Cell& cell, const VertexSet& feature) {
  return std::all_of(feature.begin(), feature.end(), [&](int vertex) {
    return std::find(cell.begin(), cell.end(), vertex) != cell.end();
  });
}

/// Numbers of edges in the order of their vertices.
std::map<VertexSet, ElementIndex> edges_of(const MeshArrays& arrays) {
  std::set<std::pair<int, int>> ordered;
  for (const Cell& cell : arrays.triangles) {
    for (const int a : cell) {
      for (const int b : cell) {
        if (a < b) ordered.insert({a, b});
      }
    }
  }
  std::map<VertexSet, ElementIndex> edges;
  for (const auto& [a, b] : ordered) {
    const auto number = static_cast<ElementIndex>(edges.size());
    edges[{a, b}] = number;
  }
  return edges;
}

MeshFeature named(const VertexSet& feature, const MeshArrays& arrays,
                  const std::map<VertexSet, ElementIndex>& edges) {
  if (feature.size() == 1) {
    return {FeatureKind::vertex, static_cast<ElementIndex>(*feature.begin())};
  }
  if (feature.size() == 2) return {FeatureKind::edge, edges.at(feature)};
  const auto first = std::find_if(arrays.triangles.begin(), arrays.triangles.end(),
                                  [&](const Cell& cell) { return has(cell, feature); });
  return {FeatureKind::face, static_cast<ElementIndex>(first - arrays.triangles.begin())};
}

}  // namespace

std::vector<MeshContact> oracle_mesh_contacts(const std::vector<Ball>& balls,
                                              const MeshArrays& arrays, double margin) {
  const auto edges = edges_of(arrays);
  std::vector<MeshContact> contacts;
  for (std::size_t k = 0; k < balls.size(); ++k) {
    std::vector<VertexSet> nearest;
    for (const Cell& cell : arrays.triangles) {
      nearest.push_back(nearest_feature(balls[k], arrays, cell, margin));
    }
    for (const VertexSet& feature : std::set(nearest.begin(), nearest.end())) {
      if (feature.empty()) continue;
      bool is_nearest_of_all = true;
      for (std::size_t t = 0; t < nearest.size(); ++t) {
        if (has(arrays.triangles[t], feature) && nearest[t] != feature) is_nearest_of_all = false;
      }
      if (!is_nearest_of_all) continue;
      contacts.push_back({static_cast<ElementIndex>(k), named(feature, arrays, edges)});
    }
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

}  // namespace abut::testing
