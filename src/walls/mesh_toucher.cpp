#include "walls/mesh_toucher.hpp"

#include "exact/features/triangle_predicate.hpp"
#include "walls/joined_vertices.hpp"
#include "walls/mesh_features.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace abut::walls {
namespace {

using Found = FoundContacts<MeshContact>;
using Contact = ImageContact<MeshContact>;

/// Keeps the nearest features of the mesh. From the contact `first` on, `contacts` holds the
/// nearest feature of each single triangle within reach. A feature is nearest in the mesh only if
/// all its triangles, `triangles_with(contact)` in number, name it. All of them lie within reach if
/// the feature does, so each has been asked.
template <class TriangleCount>
void keep_minima(std::size_t first, base::Array<Contact>& contacts,
                 TriangleCount&& triangles_with) {
  if (contacts.size() == first) return;
  if (contacts.size() == first + 1) {  // as most often, on a smooth wall
    if (!std::cmp_equal(1, triangles_with(contacts.back()))) contacts.pop_back();
    return;
  }
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

}  // namespace

void MeshToucher::operator()(const SphereCandidates<3>& candidates, Found& found) const {
  const std::size_t first = found.contacts.size();
  found.room.clear();
  for (std::size_t k = 0; k < candidates.pairs.size(); ++k) {
    const ElementIndex triangle = candidates.pairs[k].second;
    const ImageShift shift = candidates.shift(k);
    const auto part = exact::part_within_reach(candidates.sphere, triangle_at(mesh_, triangle),
                                               shift, lattice_, margin_, found.exact_decisions);
    if (!part) continue;
    const auto contact = [&](const MovedFeature& moved) {
      return Contact{{candidates.number, moved.feature}, sum(shift, moved.shift)};
    };
    found.contacts.push_back(contact(feature_of(mesh_, triangle, *part)));
    if (all_count_) continue;
    for_each_feature(mesh_, triangle,
                     [&](const MovedFeature& moved) { found.room.push_back(contact(moved)); });
  }
  if (all_count_) return keep_minima_of_all(first, found);
  std::sort(found.room.begin(), found.room.end());
  keep_minima(first, found.contacts, [&](const Contact& one) {
    const auto [begin, end] = std::equal_range(found.room.begin(), found.room.end(), one);
    return end - begin;
  });
}

void MeshToucher::keep_minima_of_all(std::size_t first, Found& found) const {
  keep_minima(first, found.contacts,
              [&](const Contact& one) { return mesh_.triangle_count(one.contact.feature); });
}

void MeshToucher::touch(std::size_t first, const BlockCandidates& candidates,
                        std::span<const std::uint8_t> parts, Found& found) const {
  const auto& pairs = candidates.pairs;
  for (std::size_t k = 0; k < pairs.size();) {
    const ElementIndex sphere = pairs[k].first;
    const auto number = static_cast<ElementIndex>(first + sphere);
    const std::size_t before = found.contacts.size();
    for (; k < pairs.size() && pairs[k].first == sphere; ++k) {
      if (parts[k] == kernels::no_part) continue;
      const auto part = static_cast<exact::TrianglePart>(parts[k]);
      const MovedFeature moved = feature_of(mesh_, pairs[k].second, part);
      found.contacts.push_back({{number, moved.feature}, moved.shift});
    }
    keep_minima_of_all(before, found);
  }
}

}  // namespace abut::walls
