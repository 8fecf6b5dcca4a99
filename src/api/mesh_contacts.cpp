#include <abut/mesh_contacts.hpp>

#include "api/feature_search.hpp"
#include "base/float_environment.hpp"
#include "base/triangle_predicate.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <cstddef>

namespace abut {
namespace {

using base::TrianglePart;
using Found = api::FoundContacts<MeshContact>;

void validate(const ElementView& spheres, const Options& options) {
  if (spheres.shape() != Shape::sphere || spheres.dimensions() != 3) {
    throw Error(ErrorCode::wrong_usage,
                "contacts with a mesh are those of spheres in three dimensions; give "
                "spheres(x, y, z, radius)");
  }
  if (options.rule.is_empty()) return;
  throw Error(ErrorCode::wrong_usage,
              "rules of who may pair are not carried against a mesh; leave out the rule, and give "
              "only the spheres that may touch it");
}

base::Triangle triangle_at(const TriangleMesh& mesh, ElementIndex number) {
  base::Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    const TriangleMesh::Point& vertex = mesh.vertices()[mesh.triangles()[number][k]];
    std::copy(vertex.begin(), vertex.end(), triangle.corner[k]);
  }
  return triangle;
}

/// The numbers of corners and of sides ascend in a triangle: the first of several nearest parts is
/// that of the smallest number.
MeshFeature feature_of(const TriangleMesh& mesh, ElementIndex triangle, TrianglePart part) {
  if (part == TrianglePart::face) return {FeatureKind::face, mesh.faces()[triangle]};
  const auto k = static_cast<std::size_t>(part);
  if (part <= TrianglePart::corner_2) return {FeatureKind::vertex, mesh.triangles()[triangle][k]};
  return {FeatureKind::edge, mesh.edges_of_triangles()[triangle][k - 3]};
}

/// Of the nearest features of all triangles, those that are the nearest of each triangle that has
/// them. A feature within reach has only triangles within reach, so that all of them were asked.
void keep_minima(const TriangleMesh& mesh, std::size_t first, base::Array<MeshContact>& contacts) {
  const auto begin = contacts.begin() + static_cast<std::ptrdiff_t>(first);
  std::sort(begin, contacts.end());
  auto kept = begin;
  for (auto run = begin; run != contacts.end();) {
    const auto next = std::upper_bound(run, contacts.end(), *run);
    const bool of_all = next - run == mesh.triangle_count(run->feature);
    if (of_all) *kept++ = *run;
    run = next;
  }
  contacts.erase(kept, contacts.end());
}

}  // namespace

MeshContactList find_mesh_contacts(const ElementView& spheres, const TriangleMesh& mesh,
                                   const Options& options) {
  const base::FloatEnvironment environment;
  validate(spheres, options);
  api::FeatureSearch<3> search(spheres, mesh.boxes().view(), options);
  return search.contacts<MeshContact>([&](const api::Candidates<3>& candidates, Found& found) {
    const std::size_t first = found.contacts.size();
    for (const ContactPair& pair : candidates.pairs) {
      const auto part = base::part_within_reach(candidates.sphere, triangle_at(mesh, pair.second),
                                                options.margin, found.exact_decisions);
      if (!part) continue;
      found.contacts.push_back({candidates.number, feature_of(mesh, pair.second, *part)});
    }
    keep_minima(mesh, first, found.contacts);
  });
}

}  // namespace abut
