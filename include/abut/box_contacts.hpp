#pragma once

#include <abut/contact_list.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/export.hpp>
#include <abut/feature_kind.hpp>
#include <abut/options.hpp>
#include <abut/pair.hpp>

#include <array>
#include <compare>
#include <cstdint>

namespace abut {

/// A part of a box: for each axis −1 on its lower bound, 1 on its upper bound, 0 between them. A
/// corner has no 0, the interior nothing else. In 2D the third is 0.
struct BoxFeature {
  FeatureKind kind = FeatureKind::interior;
  std::array<std::int8_t, 3> side{};

  friend constexpr auto operator<=>(const BoxFeature&, const BoxFeature&) = default;
};

/// A sphere that touches a box or lies within reach of it, and where.
struct BoxContact {
  ElementIndex sphere = 0;
  ElementIndex box = 0;
  BoxFeature feature;

  friend constexpr auto operator<=>(const BoxContact&, const BoxContact&) = default;
};

using BoxContactList = ContactList<BoxContact>;

/// Spheres against axis-aligned solid boxes: sphere i and box j are a contact if the distance of
/// the center to the nearest point of the box is at most r_i + margin, in real arithmetic; in a
/// periodic domain (i, j, n), with the box moved by n A. The feature is that of fewest dimensions
/// that holds the nearest point; of a flat box the lower side. Discs against rectangles likewise.
/// Ascending by (sphere, box, n), whatever order the options say; `shifts()` has the n if
/// Options::shifts asks for them.
///
/// Throws as find_contact_pairs of two sets does; Error{wrong_usage} unless the first are spheres
/// or discs and the second boxes or rectangles of as many dimensions.
[[nodiscard]] ABUT_API BoxContactList find_box_contacts(const ElementView& spheres,
                                                        const ElementView& boxes,
                                                        const Domain& domain,
                                                        const Options& options = {});

/// In open space.
[[nodiscard]] ABUT_API BoxContactList find_box_contacts(const ElementView& spheres,
                                                        const ElementView& boxes,
                                                        const Options& options = {});

}  // namespace abut
