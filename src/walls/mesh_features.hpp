#pragma once

#include "exact/features/feature_geometry.hpp"
#include "exact/features/triangle_predicate.hpp"

#include <abut/image_shift.hpp>
#include <abut/triangle_mesh.hpp>

#include <algorithm>
#include <compare>
#include <cstddef>

namespace abut::walls {

/// A feature of a mesh, moved by a shift.
struct MovedFeature {
  MeshFeature feature;
  ImageShift shift;

  friend constexpr auto operator<=>(const MovedFeature&, const MovedFeature&) = default;
};

[[nodiscard]] inline exact::Triangle triangle_at(const TriangleMesh& mesh, ElementIndex number) {
  exact::Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleMesh::Point& vertex = mesh.vertices()[mesh.triangles()[number][k]];
    std::copy(vertex.begin(), vertex.end(), triangle.corner[k]);
  }
  return triangle;
}

/// Returns the feature of the mesh that a part of a triangle belongs to. The parts come in the
/// order in which the first of several nearest ones is taken: those of triangles that have a
/// feature name the same one.
[[nodiscard]] inline MovedFeature feature_of(const TriangleMesh& mesh, ElementIndex triangle,
                                             exact::TrianglePart part) {
  const auto k = static_cast<std::size_t>(part);
  const ImageShift shift =
      mesh.feature_shifts().empty() ? ImageShift{} : mesh.feature_shifts()[triangle][k];
  if (k < 3) {
    const ElementIndex vertex = mesh.triangles()[triangle][k];
    return {{FeatureKind::vertex, mesh.vertex_features()[vertex]}, shift};
  }
  if (k < 6) return {{FeatureKind::edge, mesh.edges_of_triangles()[triangle][k - 3]}, shift};
  return {{FeatureKind::face, mesh.faces()[triangle]}, shift};
}

/// Calls act(moved_feature) once for each that a triangle has. Corners at the same place are
/// neighbors in it, and so are sides that are the same.
template <class Act>
void for_each_feature(const TriangleMesh& mesh, ElementIndex triangle, Act&& act) {
  MovedFeature last{{FeatureKind::interior, 0}, {}};
  for (std::size_t k = 0; k < 7; ++k) {
    const MovedFeature moved = feature_of(mesh, triangle, static_cast<exact::TrianglePart>(k));
    const bool is_none = moved.feature == MeshFeature{FeatureKind::edge, TriangleMesh::no_edge};
    if (is_none || moved == last) continue;
    act(moved);
    last = moved;
  }
}

/// How many corners a feature of a mesh has.
[[nodiscard]] constexpr int corner_count(FeatureKind kind) noexcept {
  return kind == FeatureKind::vertex ? 1 : kind == FeatureKind::edge ? 2 : 3;
}

/// Returns the corners of a feature, where its shift 0 has it.
[[nodiscard]] inline exact::Feature corners_of(const TriangleMesh& mesh, MeshFeature feature) {
  exact::Feature corners{};
  const auto add = [&](ElementIndex vertex) {
    const TriangleMesh::Point& point = mesh.vertices()[vertex];
    std::copy(point.begin(), point.end(), corners.corner[corners.corners++]);
  };
  switch (feature.kind) {
    case FeatureKind::vertex:
      add(feature.number);
      break;
    case FeatureKind::edge:
      for (const ElementIndex vertex : mesh.edges()[feature.number]) add(vertex);
      break;
    default:
      for (const ElementIndex vertex : mesh.triangles()[feature.number]) add(vertex);
  }
  return corners;
}

}  // namespace abut::walls
