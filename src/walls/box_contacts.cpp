#include <abut/box_contacts.hpp>

#include "base/float_environment.hpp"
#include "base/lack_of_memory.hpp"
#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "exact/features/box_feature.hpp"
#include "walls/box_measurer.hpp"
#include "walls/feature_search.hpp"
#include "walls/require_walls.hpp"

#include <algorithm>
#include <cstddef>

namespace abut {
namespace {

/// Returns the kind of feature, which follows from the number of bounds that the point lies on.
template <int Dim>
FeatureKind kind_of(const exact::BoxSides<Dim>& sides) {
  constexpr FeatureKind kinds_2d[] = {FeatureKind::interior, FeatureKind::edge,
                                      FeatureKind::vertex};
  constexpr FeatureKind kinds_3d[] = {FeatureKind::interior, FeatureKind::face, FeatureKind::edge,
                                      FeatureKind::vertex};
  const auto bounds = std::count_if(sides.begin(), sides.end(), [](int side) { return side != 0; });
  return Dim == 2 ? kinds_2d[bounds] : kinds_3d[bounds];
}

template <int Dim>
BoxContactList find(const ElementView& spheres, const ElementView& boxes, const Domain& domain,
                    const Options& options) {
  const exact::Lattice lattice = elements::lattice_of(domain);
  walls::FeatureSearch<Dim> search(spheres, boxes, domain, options);
  return search.template contacts<BoxContact>(
      [&](const walls::SphereCandidates<Dim>& candidates, walls::FoundContacts<BoxContact>& found) {
        for (std::size_t k = 0; k < candidates.pairs.size(); ++k) {
          const ElementIndex number = candidates.pairs[k].second;
          const ImageShift shift = candidates.shift(k);
          const auto sides =
              exact::sides_within_reach(candidates.sphere, elements::box_at<Dim>(boxes, number),
                                        shift, lattice, options.margin, found.exact_decisions);
          if (!sides) continue;
          BoxContact contact{candidates.number, number, {kind_of<Dim>(*sides), {}}};
          std::copy(sides->begin(), sides->end(), contact.feature.side.begin());
          found.contacts.push_back({contact, shift});
        }
      },
      walls::BoxMeasurer<Dim>(boxes, domain));
}

}  // namespace

BoxContactList find_box_contacts(const ElementView& spheres, const ElementView& boxes,
                                 const Domain& domain, const Options& options) {
  const base::FloatEnvironment environment;
  base::reporting_lack_of_memory([&] { walls::require_spheres_and_boxes(spheres, boxes); });
  return spheres.dimensions() == 2 ? find<2>(spheres, boxes, domain, options)
                                   : find<3>(spheres, boxes, domain, options);
}

BoxContactList find_box_contacts(const ElementView& spheres, const ElementView& boxes,
                                 const Options& options) {
  return find_box_contacts(spheres, boxes, Domain::open(), options);
}

}  // namespace abut
