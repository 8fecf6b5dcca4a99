#pragma once

#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/feature_kind.hpp>
#include <abut/fit_boxes.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace abut {

/// A face, an edge or a vertex of a TriangleMesh. A face has the number of its triangle, a vertex
/// its own, an edge its place in `TriangleMesh::edges()`.
struct MeshFeature {
  FeatureKind kind = FeatureKind::face;
  ElementIndex number = 0;

  friend constexpr auto operator<=>(const MeshFeature&, const MeshFeature&) = default;
};

/// A surface of triangles, with its edges. It holds a copy of the vertices.
///
/// Vertices are known by their numbers: two triangles have a common edge if both name the same two
/// vertices. Vertices of different numbers at the same place are different vertices, and triangles
/// on both sides of such a seam know nothing of each other, unless the mesh is made by `joined`.
///
/// Nothing else is asked of the triangles. An edge may have one triangle or many; a triangle may
/// have no area, or name a vertex twice; triangles of the same three vertices are one face, which
/// has the smallest of their numbers.
class TriangleMesh {
 public:
  using Point = std::array<double, 3>;
  using Corners = std::array<ElementIndex, 3>;
  using Edge = std::array<ElementIndex, 2>;

  /// In place of the edge between a vertex and itself.
  static constexpr ElementIndex no_edge = std::numeric_limits<ElementIndex>::max();

  /// `vertices` are the centers of a view in 3D.
  ///
  /// Throws Error:
  ///  invalid_input   a vertex number that is not there, a vertex of a triangle that is not finite
  ///  wrong_usage     vertices of two dimensions, cells that do not have three vertices
  ///  limit_exceeded  more than 2^32 - 1 vertices or a third as many triangles
  ABUT_API TriangleMesh(const ElementView& vertices, const Connectivity& triangles);

  /// From an array of points of three numbers.
  template <class Points>
  requires detail::PointsOf<Points, 3> TriangleMesh(Points&& vertices,
                                                    const Connectivity& triangles)
      : TriangleMesh(spheres(static_cast<Points&&>(vertices), 0.0), triangles) {}

  /// The same with vertices at the same place as one, which has the smallest of their numbers; in a
  /// periodic domain also a vertex and the image of another, decided exactly: x_v = x_w + n A. So a
  /// surface goes on through the faces of the cell, and a floor as wide as the cell has no border.
  /// Edges and faces are then one, too, if one is an image of the other. A feature is where the
  /// vertex, the first triangle with that edge, or the triangle of that number has it.
  ///
  /// Throws also what find_contact_pairs throws for the vertices. A mesh that was joined across
  /// faces of a domain has contacts in this domain only.
  [[nodiscard]] ABUT_API static TriangleMesh joined(const ElementView& vertices,
                                                    const Connectivity& triangles,
                                                    const Domain& domain = Domain::open());

  template <class Points>
  requires detail::PointsOf<Points, 3>
  [[nodiscard]] static TriangleMesh joined(Points&& vertices, const Connectivity& triangles,
                                           const Domain& domain = Domain::open()) {
    return joined(spheres(static_cast<Points&&>(vertices), 0.0), triangles, domain);
  }

  /// Number of triangles.
  [[nodiscard]] std::size_t size() const noexcept { return triangles_.size(); }

  [[nodiscard]] std::span<const Point> vertices() const noexcept { return vertices_; }
  /// Of each vertex the number of the feature that it is: its own, unless vertices were joined.
  [[nodiscard]] std::span<const ElementIndex> vertex_features() const noexcept {
    return vertex_features_;
  }
  /// Of each triangle the numbers of its vertices; ascending, unless vertices were joined.
  [[nodiscard]] std::span<const Corners> triangles() const noexcept { return triangles_; }
  /// Of each edge the numbers of its vertices; ascending, and so are the edges, unless vertices
  /// were joined.
  [[nodiscard]] std::span<const Edge> edges() const noexcept { return edges_; }
  /// Of each triangle, of vertices a, b, c, the numbers of the edges ab, ac, bc.
  [[nodiscard]] std::span<const Corners> edges_of_triangles() const noexcept {
    return triangle_edges_;
  }
  /// Of each triangle the number of its face.
  [[nodiscard]] std::span<const ElementIndex> faces() const noexcept { return faces_; }

  /// Of vertices a, b, c, edges ab, ac, bc and the face of a triangle: by how many lattice vectors
  /// they are moved from where the feature is.
  using FeatureShifts = std::array<ImageShift, 7>;
  /// Of each triangle; empty unless vertices were joined across the faces of a domain.
  [[nodiscard]] std::span<const FeatureShifts> feature_shifts() const noexcept { return shifts_; }
  /// Across whose faces vertices were joined; open if there are none.
  [[nodiscard]] const Domain& domain() const noexcept { return domain_; }

  /// How many triangles have that feature, which must be there; of their images, too, where
  /// vertices were joined across faces.
  [[nodiscard]] std::uint32_t triangle_count(MeshFeature feature) const noexcept {
    return counts_[static_cast<std::size_t>(feature.kind) - 1][feature.number];
  }

  /// A box for each triangle.
  [[nodiscard]] const FittedBoxes& boxes() const noexcept { return boxes_; }

 private:
  struct Vertices;  // with what each is the same as

  TriangleMesh(const Vertices& vertices, const Connectivity& triangles);

  void number_vertices(const Vertices& vertices, const Connectivity& triangles);
  void number_edges(const Vertices& vertices);
  void number_faces(const Vertices& vertices);
  void count_triangles();

  FittedBoxes boxes_;
  Domain domain_ = Domain::open();
  std::vector<Point> vertices_;
  std::vector<ElementIndex> vertex_features_;
  std::vector<Corners> triangles_;
  std::vector<Edge> edges_;
  std::vector<Corners> triangle_edges_;
  std::vector<ElementIndex> faces_;
  std::vector<FeatureShifts> shifts_;
  std::array<std::vector<std::uint32_t>, 3> counts_;  ///< of faces, edges, vertices
};

}  // namespace abut
