#pragma once

#include <abut/contact_list.hpp>
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

/// Spheres against a mesh (walls), in open space. Sphere i has a contact with a feature F if
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
/// then that of the smallest number counts as the one. A sphere within reach of a mesh always has
/// a contact. Ascending by (sphere, kind, number), whatever order the options say.
///
/// Throws as find_contact_pairs does; Error{wrong_usage} for elements that are not spheres and for
/// a rule of who may pair, which is not carried.
[[nodiscard]] ABUT_API MeshContactList find_mesh_contacts(const ElementView& spheres,
                                                          const TriangleMesh& mesh,
                                                          const Options& options = {});

}  // namespace abut
