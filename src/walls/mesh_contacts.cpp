#include <abut/mesh_contacts.hpp>

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "elements/lattice_of.hpp"
#include "exact/triangle_predicate.hpp"
#include "walls/feature_search.hpp"
#include "walls/joined_vertices.hpp"
#include "walls/mesh_features.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace abut {
namespace {

using exact::TrianglePart;
using Found = walls::FoundContacts<MeshContact>;
using Contact = walls::ImageContact<MeshContact>;

void require_spheres(const ElementView& spheres) {
  if (spheres.shape() == Shape::sphere && spheres.dimensions() == 3) return;
  throw Error(ErrorCode::wrong_usage,
              "contacts with a mesh are those of spheres in three dimensions; give "
              "spheres(x, y, z, radius)");
}

void require_its_domain(const TriangleMesh& mesh, const Domain& domain) {
  if (mesh.feature_shifts().empty() || mesh.domain() == domain) return;
  throw Error(ErrorCode::wrong_usage,
              "the mesh was joined across the faces of another domain; give that one, or join the "
              "mesh again for this one");
}

exact::Triangle triangle_at(const TriangleMesh& mesh, ElementIndex number) {
  exact::Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleMesh::Point& vertex = mesh.vertices()[mesh.triangles()[number][k]];
    std::copy(vertex.begin(), vertex.end(), triangle.corner[k]);
  }
  return triangle;
}

/// Keeps the nearest features of the mesh. From the contact `first` on, `contacts` holds the
/// nearest feature of each single triangle within reach. A feature is nearest in the mesh only if
/// all its triangles, `triangles_with(contact)` in number, name it. All of them lie within reach if
/// the feature does, so each has been asked.
template <class TriangleCount>
void keep_minima(std::size_t first, base::Array<Contact>& contacts,
                 TriangleCount&& triangles_with) {
  const auto begin = contacts.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, contacts.end());
  auto kept = begin;
  for (auto run = begin; run != contacts.end();) {
    const auto next = std::upper_bound(run, contacts.end(), *run);
    const Contact contact = *run;
    if (std::cmp_equal(next - run, triangles_with(contact))) *kept++ = contact;
    run = next;
  }
  contacts.erase(kept, contacts.end());
}

/// Finds the features of a mesh, and of its images, that spheres touch.
class MeshToucher {
 public:
  MeshToucher(const TriangleMesh& mesh, const Domain& domain, const Options& options)
      : mesh_(mesh),
        lattice_(elements::lattice_of(domain)),
        margin_(options.margin),
        all_count_(options.rule.is_empty()) {}

  /// Appends the contacts of one sphere. The candidates are the triangles that a rule allows.
  void operator()(const walls::SphereCandidates<3>& candidates, Found& found) const {
    const std::size_t first = found.contacts.size();
    found.room.clear();
    for (std::size_t k = 0; k < candidates.pairs.size(); ++k) {
      const ElementIndex triangle = candidates.pairs[k].second;
      const ImageShift shift = candidates.shift(k);
      const auto part = exact::part_within_reach(candidates.sphere, triangle_at(mesh_, triangle),
                                                 shift, lattice_, margin_, found.exact_decisions);
      if (!part) continue;
      const auto contact = [&](const walls::MovedFeature& moved) {
        return Contact{{candidates.number, moved.feature}, walls::sum(shift, moved.shift)};
      };
      found.contacts.push_back(contact(walls::feature_of(mesh_, triangle, *part)));
      if (all_count_) continue;
      walls::for_each_feature(mesh_, triangle, [&](const walls::MovedFeature& moved) {
        found.room.push_back(contact(moved));
      });
    }
    if (all_count_) {
      return keep_minima(first, found.contacts, [&](const Contact& one) {
        return mesh_.triangle_count(one.contact.feature);
      });
    }
    std::sort(found.room.begin(), found.room.end());
    keep_minima(first, found.contacts, [&](const Contact& one) {
      const auto [begin, end] = std::equal_range(found.room.begin(), found.room.end(), one);
      return end - begin;
    });
  }

 private:
  const TriangleMesh& mesh_;
  exact::Lattice lattice_;
  double margin_;
  bool all_count_;  ///< whether every sphere may touch every triangle
};

}  // namespace

MeshContactList find_mesh_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                   const Domain& domain, const Options& options) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] {
    require_spheres(spheres);
    require_its_domain(mesh, domain);
  });
  walls::FeatureSearch<3> search(spheres, mesh.boxes().view(), domain, options);
  return search.contacts<MeshContact>(MeshToucher(mesh, domain, options));
}

MeshContactList find_mesh_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                   const Options& options) {
  return find_mesh_contacts(spheres, mesh, Domain::open(), options);
}

}  // namespace abut
