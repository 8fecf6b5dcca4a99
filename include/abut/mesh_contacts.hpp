#pragma once

#include <abut/contact_list.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>
#include <abut/triangle_mesh.hpp>

#include <compare>

namespace abut {

/// Contact of a sphere and a feature of a mesh that touch or lie within reach of each other.
struct MeshContact {
  ElementIndex sphere = 0;  ///< index of the sphere
  MeshFeature feature;      ///< face, edge or vertex

  /// Compares the spheres, then the features.
  friend constexpr auto operator<=>(const MeshContact&, const MeshContact&) = default;
};

/// Contacts of spheres and a mesh, ascending.
using MeshContactList = ContactList<MeshContact>;

/// Finds the contacts of spheres and a mesh (walls). Sphere i has a contact with a feature F if
///
/// * the distance of its center to F is at most r_i + margin, and
/// * each triangle that has F is nearest to the center at a point of F (on an edge but not at its
///   ends, on a face but not on its edges).
///
/// Both are decided in real arithmetic. In other words: the distance to the surface has a local
/// minimum at F. So an edge is no contact where the sphere touches a face beside it, nor a vertex
/// where it touches a face or an edge that ends there; a plane is touched once, however it is
/// divided into triangles; two walls that meet in a corner are touched once each.
///
/// The nearest point of a triangle without area may lie in several features of as few dimensions;
/// then the first of these by the numbers of its vertices counts. A sphere within reach of a mesh
/// always has a contact.
///
/// In a periodic domain with the lattice vectors A, the sphere has a contact (F, n) if it has one
/// with F of the mesh moved by n A. Images of a mesh have no features in common: where the border
/// of one lies on that of the next, a sphere over it touches both, unless the mesh was made by
/// `TriangleMesh::joined` for this domain.
///
/// A rule takes triangles away from a sphere: `rule.elements` are the spheres, `rule.others` the
/// triangles, exclusions are of (sphere, triangle). The contacts of the sphere are then those with
/// the mesh without the denied triangles; features keep their numbers.
///
/// Contacts ascend by (sphere, kind, number, n), whatever order the options ask for; `shifts()`
/// holds the n if Options::shifts asks for them, and Options::quantities asks for gaps, normals,
/// points, distances and vectors.
///
/// Throws what find_contact_pairs of two sets throws, and Error{wrong_usage} for elements that are
/// not spheres and for a mesh that was joined across the faces of another domain.
[[nodiscard]] ABUT_API MeshContactList find_mesh_contacts(const ElementView& spheres,
                                                          const TriangleMesh& mesh,
                                                          const Domain& domain,
                                                          const Options& options = {});

/// Finds the contacts of spheres and a mesh in open space.
[[nodiscard]] ABUT_API MeshContactList find_mesh_contacts(const ElementView& spheres,
                                                          const TriangleMesh& mesh,
                                                          const Options& options = {});

/// Measures quantities of contacts of spheres and a mesh: of each sphere and of the point of the
/// feature that is nearest to its center, wherever both lie by now. With as many threads as the
/// options say. Throws what find_mesh_contacts throws for spheres, mesh, domain and options, and
/// Error{wrong_usage} if a contact names a sphere or a feature that is not there, if a shift is not
/// 0 on an axis that is not periodic, and if contacts of a periodic domain come without shifts.
[[nodiscard]] ABUT_API PairGeometry measure(const ElementView& spheres, const TriangleMesh& mesh,
                                            const ContactSpans<MeshContact>& contacts,
                                            Quantities quantities,
                                            const Domain& domain = Domain::open(),
                                            const Options& options = {});

/// Measures contacts with a mesh into the caller's arrays: those that are not empty. They must have
/// one entry for each contact.
ABUT_API void measure(const ElementView& spheres, const TriangleMesh& mesh,
                      const ContactSpans<MeshContact>& contacts, const PairGeometrySpans& geometry,
                      const Domain& domain = Domain::open(), const Options& options = {});

}  // namespace abut
