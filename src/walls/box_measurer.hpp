#pragma once

#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "exact/box.hpp"
#include "exact/features/feature_geometry.hpp"
#include "exact/features/solid_geometry.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <abut/box_contacts.hpp>
#include <abut/domain.hpp>
#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>
#include <abut/quantity.hpp>

#include <array>
#include <cstddef>
#include <optional>

namespace abut::walls {

/// A box as a sphere outside of it sees it: its nearest corner, with both without the axes along
/// which the center lies between the bounds. What exact::geometry_of makes of a box in open space.
struct BoxCorner {
  exact::Sphere<3> sphere;
  exact::Feature corner;
  std::array<double, 3> point;  ///< of the box that is nearest to the center
};

/// Returns it, unless the center lies in the box or on it.
template <int Dim>
[[nodiscard]] std::optional<BoxCorner> seen_corner(const exact::Sphere<Dim>& sphere,
                                                   const exact::Box<Dim>& box) noexcept {
  BoxCorner seen{{{}, sphere.radius}, {{}, 1}, {}};
  bool is_inside = true;
  for (int axis = 0; axis < Dim; ++axis) {
    const double x = sphere.center[axis];
    const auto k = static_cast<std::size_t>(axis);
    seen.point[k] = x + 0.0;
    if (x > box.lower[axis] && x < box.upper[axis]) continue;
    const double bound = x <= box.lower[axis] ? box.lower[axis] : box.upper[axis];
    seen.sphere.center[axis] = x;
    seen.corner.corner[0][axis] = bound;
    seen.point[k] = bound + 0.0;
    is_inside = is_inside && bound == x;
  }
  if (is_inside) return std::nullopt;
  return seen;
}

/// Measures contacts with boxes.
template <int Dim>
class BoxMeasurer {
 public:
  /// `boxes` must outlive it.
  BoxMeasurer(const ElementView& boxes, const Domain& domain)
      : boxes_(boxes), lattice_(elements::lattice_of(domain)) {}

  [[nodiscard]] exact::Box<Dim> box(const BoxContact& contact) const {
    return elements::box_at<Dim>(boxes_, contact.box);
  }

  [[nodiscard]] exact::FeatureGeometry operator()(const exact::Sphere<Dim>& sphere,
                                                  const BoxContact& contact,
                                                  const ImageShift& shift,
                                                  Quantities wanted) const {
    return exact::geometry_of(sphere, box(contact), shift, lattice_, wanted);
  }

 private:
  const ElementView& boxes_;
  exact::Lattice lattice_;
};

}  // namespace abut::walls
