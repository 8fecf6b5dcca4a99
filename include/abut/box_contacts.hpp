#pragma once

#include <abut/contact_list.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/feature_kind.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>
#include <abut/pair_geometry.hpp>
#include <abut/quantity.hpp>

#include <array>
#include <compare>
#include <cstdint>

namespace abut {

/// Part of a box: its interior, a face, an edge or a vertex.
struct BoxFeature {
  FeatureKind kind = FeatureKind::interior;  ///< vertex, edge, face or interior
  /// Place on each axis: −1 on the lower bound of the box, 1 on the upper one, 0 between them. A
  /// vertex has no 0, the interior only zeros. In 2D the third is 0.
  std::array<std::int8_t, 3> side{};

  /// Compares the kinds, then the sides.
  friend constexpr auto operator<=>(const BoxFeature&, const BoxFeature&) = default;
};

/// Contact of a sphere and a box that touch or lie within reach of each other.
struct BoxContact {
  ElementIndex sphere = 0;  ///< index of the sphere
  ElementIndex box = 0;     ///< index of the box
  BoxFeature feature;       ///< part of the box that holds the point nearest to the center

  /// Compares the spheres, then the boxes, then the features.
  friend constexpr auto operator<=>(const BoxContact&, const BoxContact&) = default;
};

/// Contacts of spheres and boxes, ascending.
using BoxContactList = ContactList<BoxContact>;

/// Finds the contacts of spheres and axis-aligned solid boxes, or of discs and rectangles.
///
/// Sphere i and box j are a contact if the distance of the center to the nearest point of the box
/// is at most r_i + margin, in real arithmetic; in a periodic domain (i, j, n) is one if this holds
/// with the box moved by n A. The feature is the one of fewest dimensions that holds the nearest
/// point; where a box is flat, the lower side counts.
///
/// Contacts ascend by (sphere, box, n), whatever order the options ask for; `shifts()` holds the n
/// if Options::shifts asks for them, and Options::quantities asks for gaps, normals, points,
/// distances and vectors.
///
/// Throws what find_contact_pairs of two sets throws, and Error{wrong_usage} unless the first are
/// spheres or discs and the second boxes or rectangles of as many dimensions.
[[nodiscard]] ABUT_API BoxContactList find_box_contacts(const ElementView& spheres,
                                                        const ElementView& boxes,
                                                        const Domain& domain,
                                                        const Options& options = {});

/// Finds the contacts of spheres and boxes in open space.
[[nodiscard]] ABUT_API BoxContactList find_box_contacts(const ElementView& spheres,
                                                        const ElementView& boxes,
                                                        const Options& options = {});

/// Measures quantities of contacts of spheres and boxes: of each sphere and of its box, wherever
/// both lie by now; the feature of the contact does not count. With as many threads as the options
/// say. Throws what find_box_contacts throws for spheres, boxes, domain and options, and
/// Error{wrong_usage} if a contact names a sphere or a box that is not there, if a shift is not 0
/// on an axis that is not periodic, and if contacts of a periodic domain come without shifts.
[[nodiscard]] ABUT_API PairGeometry measure(const ElementView& spheres, const ElementView& boxes,
                                            const ContactSpans<BoxContact>& contacts,
                                            Quantities quantities,
                                            const Domain& domain = Domain::open(),
                                            const Options& options = {});

/// Measures contacts with boxes into the caller's arrays: those that are not empty. They must have
/// one entry for each contact.
ABUT_API void measure(const ElementView& spheres, const ElementView& boxes,
                      const ContactSpans<BoxContact>& contacts, const PairGeometrySpans& geometry,
                      const Domain& domain = Domain::open(), const Options& options = {});

}  // namespace abut
