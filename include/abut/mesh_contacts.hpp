#pragma once

#include <abut/contact_list.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/triangle_mesh.hpp>

#include <compare>

namespace abut {

/// A sphere that touches a mesh or lies within reach of it, and where.
struct MeshContact {
  ElementIndex sphere = 0;
  MeshFeature feature;

  friend constexpr auto operator<=>(const MeshContact&, const MeshContact&) = default;
};

using MeshContactList = ContactList<MeshContact>;

/// Spheres against a mesh (walls). Sphere i has a contact with a feature F if
///
///  * the distance of its center to F is at most r_i + margin, and
///  * each triangle that has F is nearest to the center at a point of F (on an edge but not at its
///    ends, on a face but not on its edges).
///
/// Both are decided in real arithmetic. In other words: the distance to the surface has a local
/// minimum at F. So an edge is no contact where the sphere touches a face beside it, nor a vertex
/// where it touches a face or an edge that ends there; a plane is touched once, however it is
/// divided into triangles; two walls that meet in a corner are touched once each.
///
/// Where a triangle has no area its nearest point may be in several features of as few dimensions;
/// then the first by the numbers of its vertices counts as the one. A sphere within reach of a mesh
/// always has a contact.
///
/// In a periodic domain the sphere has a contact (F, n) if it has one with F of the mesh moved by
/// n A; the lattice vectors A. Images of a mesh know nothing of each other: where the border of one
/// lies on that of the next, a sphere over it touches both, unless the mesh was made by
/// `TriangleMesh::joined` for this domain.
///
/// A rule says which triangles are there for a sphere: `rule.elements` are the spheres,
/// `rule.others` the triangles, exclusions are of (sphere, triangle). Those that it denies do not
/// count, neither as what is touched nor as what has F, as if the mesh were without them;
/// features keep their numbers.
///
/// Ascending by (sphere, kind, number, n), whatever order the options say; `shifts()` has the n if
/// Options::shifts asks for them.
///
/// Throws as find_contact_pairs of two sets does; Error{wrong_usage} for elements that are not
/// spheres, and for a mesh that was joined across the faces of another domain.
[[nodiscard]] ABUT_API MeshContactList find_mesh_contacts(const ElementView& spheres,
                                                          const TriangleMesh& mesh,
                                                          const Domain& domain,
                                                          const Options& options = {});

/// In open space.
[[nodiscard]] ABUT_API MeshContactList find_mesh_contacts(const ElementView& spheres,
                                                          const TriangleMesh& mesh,
                                                          const Options& options = {});

}  // namespace abut
