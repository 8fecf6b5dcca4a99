// Meshes that move: new positions for the vertices of the same triangles.

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "base/shortest_text.hpp"
#include "elements/gathered_elements.hpp"

#include <abut/error.hpp>
#include <abut/triangle_mesh.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace abut {
namespace {

using Point = TriangleMesh::Point;

bool is_finite(const Point& point) noexcept {
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

/// The fixed sequence that the header states.
Point moved(const Point& v, const Motion& motion) noexcept {
  Point result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& row = motion.rotation[k];
    result[k] = ((row[0] * v[0] + row[1] * v[1]) + row[2] * v[2]) + motion.translation[k];
  }
  return result;
}

void require_finite(const Motion& motion) {
  bool finite = is_finite(motion.translation);
  for (const auto& row : motion.rotation) finite = finite && is_finite(row);
  if (finite) return;
  throw Error(ErrorCode::invalid_input,
              "a motion has a number that is not finite; give finite rotations and translations");
}

[[noreturn]] void refuse_vertex(ElementIndex vertex, const std::string& why) {
  throw Error(ErrorCode::invalid_input, "vertex " + std::to_string(vertex) + " of the mesh " + why);
}

void require_finite(const Point& point, ElementIndex vertex) {
  if (is_finite(point)) return;
  std::size_t axis = 0;
  while (std::isfinite(point[axis])) ++axis;
  refuse_vertex(vertex, std::string("has ") + "xyz"[axis] + " = " +
                            base::shortest_text(point[axis]) + "; positions must be finite");
}

}  // namespace

void TriangleMesh::require_movable() const {
  if (shifts_.empty()) return;
  throw Error(ErrorCode::wrong_usage,
              "the mesh was joined across the faces of its domain, where it cannot move; make a "
              "new mesh, or one that is not joined");
}

void TriangleMesh::fit_boxes_again() noexcept {
  for (std::size_t k = 0; k < size(); ++k) {
    const auto& [a, b, c] = triangles_[k];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [lower, upper] =
          std::minmax({vertices_[a][axis], vertices_[b][axis], vertices_[c][axis]});
      boxes_.lower[axis][k] = lower;
      boxes_.upper[axis][k] = upper;
    }
  }
}

void TriangleMesh::move(const Motion& motion) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    require_movable();
    require_finite(motion);
    const auto rest = rest_vertices();
    for (const Corners& corners : triangles_) {
      for (const ElementIndex vertex : corners) require_finite(moved(rest[vertex], motion), vertex);
    }
    if (rest_.empty()) rest_ = vertices_;
    for (std::size_t k = 0; k < rest_.size(); ++k) vertices_[k] = moved(rest_[k], motion);
    motion_ = motion;
    fit_boxes_again();
  });
}

void TriangleMesh::deform(const ElementView& vertices) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    require_movable();
    if (vertices.size() != vertices_.size() || vertices.dimensions() != 3) {
      throw Error(ErrorCode::wrong_usage,
                  "the mesh has " + std::to_string(vertices_.size()) +
                      " vertices in 3 dimensions; give as many new positions");
    }
    const auto place = [&](ElementIndex vertex) {
      const exact::Sphere<3> given = elements::sphere_at<3>(vertices, vertex);
      return Point{given.center[0], given.center[1], given.center[2]};
    };
    for (const Corners& corners : triangles_) {
      for (const ElementIndex vertex : corners) {
        require_finite(place(vertex), vertex);
        const ElementIndex joined_with = vertex_features_[vertex];
        if (place(vertex) == place(joined_with)) continue;
        refuse_vertex(vertex, "was joined with vertex " + std::to_string(joined_with) +
                                  "; both must stay at one place");
      }
    }
    for (std::size_t k = 0; k < vertices_.size(); ++k) {
      vertices_[k] = place(static_cast<ElementIndex>(k));
    }
    rest_.clear();
    motion_ = {};
    fit_boxes_again();
  });
}

}  // namespace abut
