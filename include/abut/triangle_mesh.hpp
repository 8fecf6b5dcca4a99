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

/// A face, an edge or a vertex of a TriangleMesh.
struct MeshFeature {
  FeatureKind kind = FeatureKind::face;  ///< face, edge or vertex
  /// Number of the triangle for a face, of the vertex for a vertex, and the place in
  /// `TriangleMesh::edges()` for an edge.
  ElementIndex number = 0;

  /// Compares the kinds, then the numbers.
  friend constexpr auto operator<=>(const MeshFeature&, const MeshFeature&) = default;
};

/// A motion that moves a vertex v to R v + t. It is rigid if R is a rotation, which nothing asks
/// for: the rounding of a rotation, a mirror or a stretch are all moved as they are given.
struct Motion {
  /// Rows of R.
  std::array<std::array<double, 3>, 3> rotation{
      {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
  std::array<double, 3> translation{};  ///< t

  /// Compares the numbers.
  friend bool operator==(const Motion&, const Motion&) = default;
};

/// A surface of triangles, with its edges. It holds a copy of the vertices.
///
/// Vertices are identified by their numbers: two triangles have a common edge if both name the same
/// two vertices. Vertices with different numbers at the same place are different vertices, and
/// triangles on both sides of such a seam have no feature in common, unless the mesh is made by
/// `joined`.
///
/// Triangles need not fulfil anything else. An edge may have one triangle or many; a triangle may
/// have no area, or name a vertex twice; triangles of the same three vertices are one face, which
/// has the smallest of their numbers.
class TriangleMesh {
 public:
  /// Position of a vertex.
  using Point = std::array<double, 3>;
  /// Three numbers of a triangle: of its vertices or of its edges.
  using Corners = std::array<ElementIndex, 3>;
  /// Numbers of the two vertices of an edge.
  using Edge = std::array<ElementIndex, 2>;

  /// Stands for the edge between a vertex and itself, which does not exist.
  static constexpr ElementIndex no_edge = std::numeric_limits<ElementIndex>::max();

  /// Makes a mesh; `vertices` are the centers of a view in 3D.
  ///
  /// Throws Error:
  ///
  /// * `invalid_input`: a vertex number that does not exist, a vertex of a triangle that is not
  ///   finite;
  /// * `wrong_usage`: vertices of two dimensions, cells that do not have three vertices;
  /// * `limit_exceeded`: more than 2^32 - 1 vertices or a third as many triangles.
  ABUT_API TriangleMesh(const ElementView& vertices, const Connectivity& triangles);

  /// Makes a mesh; `vertices` is an array of points of three numbers.
  template <class Points>
  requires detail::PointsOf<Points, 3> TriangleMesh(Points&& vertices,
                                                    const Connectivity& triangles)
      : TriangleMesh(spheres(static_cast<Points&&>(vertices), 0.0), triangles) {}

  /// Makes a mesh in which vertices at the same place are one vertex, which has the smallest of
  /// their numbers. In a periodic domain a vertex and the image of another are one, too, decided
  /// exactly: x_v = x_w + n A. So a surface goes on through the faces of the cell, and a floor as
  /// wide as the cell has no border. Edges and faces are then one, too, if one is an image of the
  /// other. The place of a feature is that of the vertex, of the edge in the first triangle that
  /// has it, or of the face in the triangle of that number.
  ///
  /// Throws also what find_contact_pairs throws for the vertices. A mesh that was joined across
  /// faces of a domain has contacts in this domain only.
  [[nodiscard]] ABUT_API static TriangleMesh joined(const ElementView& vertices,
                                                    const Connectivity& triangles,
                                                    const Domain& domain = Domain::open());

  /// Makes a mesh with joined vertices; `vertices` is an array of points of three numbers.
  template <class Points>
  requires detail::PointsOf<Points, 3>
  [[nodiscard]] static TriangleMesh joined(Points&& vertices, const Connectivity& triangles,
                                           const Domain& domain = Domain::open()) {
    return joined(spheres(static_cast<Points&&>(vertices), 0.0), triangles, domain);
  }

  /// Moves the mesh to where the motion takes it from its rest position, which is the one that it
  /// was made or last deformed with. Each coordinate becomes
  ///
  ///     ((R_k0 * v_0 + R_k1 * v_1) + R_k2 * v_2) + t_k
  ///
  /// in double precision, each operation rounded once, in this order. These rounded numbers are the
  /// vertices from then on: `vertices()` returns them, and contacts are exactly those with them.
  /// Numbers of features stay. It allocates nothing after the first call.
  ///
  /// Throws Error{invalid_input} for a motion that is not finite or takes a vertex of a triangle
  /// beyond the doubles, and Error{wrong_usage} for a mesh that was joined across the faces of a
  /// domain; then nothing has changed.
  ABUT_API void move(const Motion& motion);

  /// Gives the mesh a new rest position: as many vertices as it has. Features keep their numbers.
  /// It allocates nothing. Throws what the constructor throws for vertices, Error{wrong_usage} for
  /// another number of them and as move does, and Error{invalid_input} if vertices that were joined
  /// do not lie at one place; then nothing has changed.
  ABUT_API void deform(const ElementView& vertices);

  /// Gives the mesh a new rest position; `vertices` is an array of points of three numbers.
  template <class Points>
  requires detail::PointsOf<Points, 3>
  void deform(Points&& vertices) { deform(spheres(static_cast<Points&&>(vertices), 0.0)); }

  /// Positions of the vertices at rest.
  [[nodiscard]] std::span<const Point> rest_vertices() const noexcept {
    return rest_.empty() ? vertices_ : rest_;
  }
  /// Motion from the position at rest to that of `vertices()`.
  [[nodiscard]] const Motion& motion() const noexcept { return motion_; }

  /// Number of triangles.
  [[nodiscard]] std::size_t size() const noexcept { return triangles_.size(); }

  /// Positions of the vertices.
  [[nodiscard]] std::span<const Point> vertices() const noexcept { return vertices_; }
  /// Number of the feature that each vertex is: its own, unless vertices were joined.
  [[nodiscard]] std::span<const ElementIndex> vertex_features() const noexcept {
    return vertex_features_;
  }
  /// Vertices of each triangle; ascending, unless vertices were joined.
  [[nodiscard]] std::span<const Corners> triangles() const noexcept { return triangles_; }
  /// Vertices of each edge; they ascend, and so do the edges, unless vertices were joined.
  [[nodiscard]] std::span<const Edge> edges() const noexcept { return edges_; }
  /// Edges of each triangle: of vertices a, b, c the numbers of the edges ab, ac, bc.
  [[nodiscard]] std::span<const Corners> edges_of_triangles() const noexcept {
    return triangle_edges_;
  }
  /// Face of each triangle: the smallest number of the triangles that are the same face.
  [[nodiscard]] std::span<const ElementIndex> faces() const noexcept { return faces_; }

  /// Shifts of the parts of a triangle, in the order vertices a, b, c, edges ab, ac, bc, face: the
  /// lattice vectors by which the part is moved from the place of its feature.
  using FeatureShifts = std::array<ImageShift, 7>;
  /// Shifts for each triangle; empty unless vertices were joined across the faces of a domain.
  [[nodiscard]] std::span<const FeatureShifts> feature_shifts() const noexcept { return shifts_; }
  /// Domain across whose faces vertices were joined; open if none were.
  [[nodiscard]] const Domain& domain() const noexcept { return domain_; }

  /// Number of triangles that have a feature, which must exist. Images of triangles count, too, if
  /// vertices were joined across faces.
  [[nodiscard]] std::uint32_t triangle_count(MeshFeature feature) const noexcept {
    return counts_[static_cast<std::size_t>(feature.kind) - 1][feature.number];
  }

  /// Boxes around the triangles, one for each.
  [[nodiscard]] const FittedBoxes& boxes() const noexcept { return boxes_; }

 private:
  struct Vertices;  // with what each is the same as

  TriangleMesh(const Vertices& vertices, const Connectivity& triangles);

  void number_vertices(const Vertices& vertices, const Connectivity& triangles);
  void number_edges(const Vertices& vertices);
  void number_faces(const Vertices& vertices);
  void count_triangles();

  void require_movable() const;
  void fit_boxes_again() noexcept;

  FittedBoxes boxes_;
  Domain domain_ = Domain::open();
  Motion motion_;
  std::vector<Point> vertices_;
  std::vector<Point> rest_;  ///< none while the mesh has never been moved
  std::vector<ElementIndex> vertex_features_;
  std::vector<Corners> triangles_;
  std::vector<Edge> edges_;
  std::vector<Corners> triangle_edges_;
  std::vector<ElementIndex> faces_;
  std::vector<FeatureShifts> shifts_;
  std::array<std::vector<std::uint32_t>, 3> counts_;  ///< of faces, edges, vertices
};

}  // namespace abut
