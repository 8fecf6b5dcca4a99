#pragma once

#include "elements/gathered_elements.hpp"
#include "elements/lattice_of.hpp"
#include "exact/box.hpp"
#include "exact/features/box_feature.hpp"
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
#include <cstdint>

namespace abut::walls {

/// Coordinates of the point of a box that is nearest to a center, as far as they are known before
/// anything is moved.
struct NearestCoordinates {
  unsigned axes = 7;  ///< a bit for each axis where it is known
  std::array<double, 3> value{};

  void write_to(std::array<double, 3>& point) const noexcept {
    if (axes == 7) {
      point = value;
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((axes >> axis & 1u) != 0) point[axis] = value[axis];
    }
  }
};

/// A box as a sphere outside of it sees it: its nearest corner, with both without the axes along
/// which the center lies between the bounds. What exact::geometry_of makes of a box.
struct BoxCorner {
  exact::Sphere<3> sphere{};
  exact::Feature corner{{}, 1};
  NearestCoordinates point;

  /// As if the center lay between the bounds.
  template <int Dim>
  void start(const exact::Sphere<Dim>& given) noexcept {
    sphere.radius = given.radius;
    point.axes = 7;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      sphere.center[axis] = corner.corner[0][axis] = 0.0;
      point.value[axis] = given.center[axis] + 0.0;
    }
  }
};

/// Finds it, unless the center lies in the box or on it: then it returns false.
template <int Dim>
[[nodiscard]] bool see_corner(const exact::Sphere<Dim>& sphere, const exact::Box<Dim>& box,
                              BoxCorner& seen) noexcept {
  seen.start(sphere);
  bool is_outside = false;
  for (int axis = 0; axis < Dim; ++axis) {
    const double x = sphere.center[axis];
    if (x > box.lower[axis] && x < box.upper[axis]) continue;
    const double bound = x <= box.lower[axis] ? box.lower[axis] : box.upper[axis];
    seen.sphere.center[axis] = x;
    seen.corner.corner[0][axis] = bound;
    seen.point.value[static_cast<std::size_t>(axis)] = bound + 0.0;
    is_outside = is_outside || bound != x;
  }
  return is_outside;
}

/// Finds that of a box that a shift moves, with the corner where it is given, unless the center
/// lies in the box: then it returns false.
template <int Dim>
[[nodiscard]] bool see_corner(const exact::Sphere<Dim>& sphere, const exact::Box<Dim>& box,
                              const ImageShift& shift, const exact::Lattice& lattice,
                              BoxCorner& seen) noexcept {
  std::uint64_t doubts = 0;
  const exact::LatticeSteps<Dim> steps(shift, lattice);
  const exact::BoxSides<Dim> sides = exact::nearest_sides(sphere, box, steps, doubts);
  seen.start(sphere);
  for (int axis = 0; axis < Dim; ++axis) {
    const int side = sides[static_cast<std::size_t>(axis)];
    if (side == 0) continue;
    seen.sphere.center[axis] = sphere.center[axis];
    seen.corner.corner[0][axis] = side < 0 ? box.lower[axis] : box.upper[axis];
    seen.point.axes &= ~(1u << axis);
  }
  return seen.point.axes != 7;
}

/// Measures contacts with boxes.
template <int Dim>
class BoxMeasurer {
 public:
  /// `boxes` must outlive it.
  BoxMeasurer(const ElementView& boxes, const Domain& domain)
      : boxes_(boxes), lattice_(elements::lattice_of(domain)) {}

  [[nodiscard]] const exact::Lattice& lattice() const noexcept { return lattice_; }

  /// Finds the corner that the sphere sees, if it is outside of the box.
  [[nodiscard]] bool see(const exact::Sphere<Dim>& sphere, const BoxContact& contact,
                         BoxCorner& seen) const {
    return see_corner<Dim>(sphere, elements::box_at<Dim>(boxes_, contact.box), seen);
  }

  /// The same of a box that the shift moves, with the corner where it is given.
  [[nodiscard]] bool see(const exact::Sphere<Dim>& sphere, const BoxContact& contact,
                         const ImageShift& shift, BoxCorner& seen) const {
    const exact::Box<Dim> box = elements::box_at<Dim>(boxes_, contact.box);
    return see_corner<Dim>(sphere, box, shift, lattice_, seen);
  }

  [[nodiscard]] exact::FeatureGeometry operator()(const exact::Sphere<Dim>& sphere,
                                                  const BoxContact& contact,
                                                  const ImageShift& shift,
                                                  Quantities wanted) const {
    return exact::geometry_of(sphere, elements::box_at<Dim>(boxes_, contact.box), shift, lattice_,
                              wanted);
  }

 private:
  const ElementView& boxes_;
  exact::Lattice lattice_;
};

}  // namespace abut::walls
