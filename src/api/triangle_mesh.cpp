#include <abut/triangle_mesh.hpp>

#include "api/gathered_elements.hpp"
#include "api/vertex_numbers.hpp"
#include "base/float_environment.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <numeric>
#include <string>

namespace abut {
namespace {

using Corners = TriangleMesh::Corners;
using Edge = TriangleMesh::Edge;

/// Three edges of each triangle, and `no_edge`, must have numbers.
constexpr std::size_t most_vertices = std::numeric_limits<ElementIndex>::max();
constexpr std::size_t most_triangles = most_vertices / 3;

[[noreturn]] void refuse_count(std::size_t count, const char* what, std::size_t most) {
  throw Error(ErrorCode::limit_exceeded, std::to_string(count) + " " + what +
                                             "; a mesh numbers at most " + std::to_string(most) +
                                             ": split it");
}

void validate(const ElementView& vertices, const Connectivity& triangles) {
  if (vertices.dimensions() != 3) {
    throw Error(ErrorCode::wrong_usage,
                "the vertices have 2 dimensions; a triangle mesh wants three coordinates of each");
  }
  if (triangles.vertices_per_cell() != 3) {
    throw Error(ErrorCode::wrong_usage, "cells of " +
                                            std::to_string(triangles.vertices_per_cell()) +
                                            " vertices; a triangle mesh wants three in each");
  }
  if (vertices.size() > most_vertices) refuse_count(vertices.size(), "vertices", most_vertices);
  if (triangles.size() > most_triangles) {
    refuse_count(triangles.size(), "triangles", most_triangles);
  }
}

/// The ends of the edges 01, 02, 12 of a triangle.
std::array<Edge, 3> edges_between(const Corners& corners) {
  return {Edge{corners[0], corners[1]}, Edge{corners[0], corners[2]}, Edge{corners[1], corners[2]}};
}

/// Counts one triangle for each feature that it has, for one that it names twice, too.
void count_once(Corners features, std::vector<std::uint32_t>& counts) {
  std::sort(features.begin(), features.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const bool repeated = k > 0 && features[k] == features[k - 1];
    if (!repeated && features[k] != TriangleMesh::no_edge) ++counts[features[k]];
  }
}

}  // namespace

TriangleMesh::TriangleMesh(const ElementView& vertices, const Connectivity& triangles)
    : boxes_((validate(vertices, triangles), fit_boxes(vertices, triangles))) {
  const base::FloatEnvironment environment;
  vertices_.resize(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const base::Sphere<3> vertex = api::sphere_at<3>(vertices, k);
    std::copy_n(vertex.center, 3, vertices_[k].begin());
  }
  const api::VertexNumbers numbers(triangles, vertices.size());
  triangles_.resize(triangles.size());
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    Corners& corners = triangles_[k];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      corners[corner] = static_cast<ElementIndex>(numbers.at(k, corner));
    }
    std::sort(corners.begin(), corners.end());
  }
  number_edges();
  number_faces();
  count_triangles();
}

void TriangleMesh::number_edges() {
  for (const Corners& corners : triangles_) {
    for (const Edge& edge : edges_between(corners)) {
      if (edge[0] != edge[1]) edges_.push_back(edge);
    }
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  triangle_edges_.reserve(size());
  for (const Corners& corners : triangles_) {
    Corners numbers{no_edge, no_edge, no_edge};
    const std::array<Edge, 3> ends = edges_between(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      if (ends[k][0] == ends[k][1]) continue;
      const auto place = std::lower_bound(edges_.begin(), edges_.end(), ends[k]);
      numbers[k] = static_cast<ElementIndex>(place - edges_.begin());
    }
    triangle_edges_.push_back(numbers);
  }
}

void TriangleMesh::number_faces() {
  std::vector<ElementIndex> by_corners(size());
  std::iota(by_corners.begin(), by_corners.end(), ElementIndex{0});
  std::sort(by_corners.begin(), by_corners.end(), [&](ElementIndex a, ElementIndex b) {
    return triangles_[a] != triangles_[b] ? triangles_[a] < triangles_[b] : a < b;
  });
  faces_.resize(size());
  for (std::size_t k = 0; k < size(); ++k) {
    const ElementIndex triangle = by_corners[k];
    const bool repeated = k > 0 && triangles_[by_corners[k - 1]] == triangles_[triangle];
    faces_[triangle] = repeated ? faces_[by_corners[k - 1]] : triangle;
  }
}

void TriangleMesh::count_triangles() {
  auto& [of_faces, of_edges, of_vertices] = counts_;
  of_faces.resize(size());
  of_edges.resize(edges_.size());
  of_vertices.resize(vertices_.size());
  for (std::size_t k = 0; k < size(); ++k) {
    ++of_faces[faces_[k]];
    count_once(triangle_edges_[k], of_edges);
    count_once(triangles_[k], of_vertices);
  }
}

}  // namespace abut
