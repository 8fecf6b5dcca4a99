#include "exact/features/solid_geometry.hpp"

#include "exact/center_vector.hpp"
#include "exact/features/box_feature.hpp"
#include "exact/numbers/exact_accumulator.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace abut::exact {
namespace {

double clamped(double value) noexcept {
  constexpr double most = std::numeric_limits<double>::max();
  return std::clamp(value, -most, most) + 0.0;
}

Sphere<3> in_space(const Sphere<2>& sphere) noexcept {
  return {{sphere.center[0], sphere.center[1], 0.0}, sphere.radius};
}
const Sphere<3>& in_space(const Sphere<3>& sphere) noexcept {
  return sphere;
}

/// Returns the lattice without the numbers that have no meaning in fewer dimensions.
template <int Dim>
Lattice in_space(Lattice lattice) noexcept {
  if (Dim == 3) return lattice;
  for (auto& vector : lattice.vectors) vector[2] = 0.0;
  lattice.periodic[2] = false;
  return lattice;
}

/// A bound of the box, rounded once where it is moved.
template <int Dim>
double moved_bound(double bound, const LatticeSteps<Dim>& steps, int axis) noexcept {
  if (steps.empty()) return bound + 0.0;
  Sphere<Dim> corner{};
  corner.center[axis] = bound;
  return clamped(any_component(Sphere<Dim>{}, corner, steps, axis).high);
}

/// A face of a box that has a sphere's center inside.
struct Face {
  int axis;
  bool is_upper;
};

/// The depth of a center behind the faces of a box around it, exactly.
template <int Dim>
class Depths {
 public:
  Depths(const Sphere<Dim>& sphere, const Box<Dim>& box, const LatticeSteps<Dim>& steps) noexcept
      : sphere_(sphere), box_(box), steps_(steps) {}

  /// The first of the nearest faces, lower ones before upper ones.
  [[nodiscard]] Face nearest() const noexcept {
    Face best{0, false};
    for (int axis = 0; axis < Dim; ++axis) {
      for (const Face face : {Face{axis, false}, Face{axis, true}}) {
        ExactAccumulator<1> deeper;
        add(face, 1, deeper);
        add(best, -1, deeper);
        if (deeper.sign() < 0) best = face;
      }
    }
    return best;
  }

  /// The depth behind a face and another number, rounded once.
  [[nodiscard]] double with(const Face& face, double number) const noexcept {
    ExactAccumulator<1> sum;
    add(face, 1, sum);
    sum.add(number, 1);
    return clamped(sum.rounded());
  }

  [[nodiscard]] double bound(const Face& face) const noexcept {
    return face.is_upper ? box_.upper[face.axis] : box_.lower[face.axis];
  }

 private:
  /// Adds sign * (x - bound - n A) for a lower face, and its opposite for an upper one.
  void add(const Face& face, int sign, ExactAccumulator<1>& sum) const noexcept {
    const std::int64_t factor = face.is_upper ? -sign : sign;
    sum.add(sphere_.center[face.axis], factor);
    sum.add(bound(face), -factor);
    for (const auto& step : steps_) sum.add(step.vector[face.axis], -factor * step.number);
  }

  const Sphere<Dim>& sphere_;
  const Box<Dim>& box_;
  const LatticeSteps<Dim>& steps_;
};

template <int Dim>
FeatureGeometry inside(const Sphere<Dim>& sphere, const Box<Dim>& box,
                       const LatticeSteps<Dim>& steps) noexcept {
  const Depths<Dim> depths(sphere, box, steps);
  const Face face = depths.nearest();
  const auto axis = static_cast<std::size_t>(face.axis);
  const double depth = depths.with(face, 0.0);
  const double inwards = face.is_upper ? -1.0 : 1.0;
  FeatureGeometry geometry;
  geometry.gap = 0.0 - depths.with(face, sphere.radius);
  geometry.distance = 0.0 - depth;
  geometry.normal[axis] = inwards;
  geometry.vector[axis] = 0.0 - inwards * depth;
  for (std::size_t k = 0; k < Dim; ++k) geometry.point[k] = sphere.center[k] + 0.0;
  geometry.point[axis] = moved_bound(depths.bound(face), steps, face.axis);
  return geometry;
}

/// Tells whether the center lies on all the bounds that the sides name.
template <int Dim>
bool is_inside(const SideCorner<Dim>& across, const ImageShift& shift) noexcept {
  const LatticeSteps<Dim> steps(shift, across.lattice);
  for (int axis = 0; axis < Dim; ++axis) {
    const double apart = steps.empty()
                             ? across.nearest.center[axis] - across.center.center[axis]
                             : any_component(across.center, across.nearest, steps, axis).high;
    if (apart != 0.0) return false;
  }
  return true;
}

}  // namespace

template <int Dim>
FeatureGeometry geometry_of(const Sphere<Dim>& sphere, const Box<Dim>& box, const ImageShift& shift,
                            const Lattice& lattice, Quantities wanted) noexcept {
  const LatticeSteps<Dim> steps(shift, lattice);
  std::uint64_t doubts = 0;
  const BoxSides<Dim> sides = nearest_sides(sphere, box, steps, doubts);
  const SideCorner<Dim> across(sphere, box, sides, lattice);
  if (is_inside(across, shift)) return inside(sphere, box, steps);
  const Sphere<3> corner = in_space(across.nearest);
  const Feature feature{{{corner.center[0], corner.center[1], corner.center[2]}, {}, {}}, 1};
  FeatureGeometry geometry =
      geometry_of(in_space(across.center), feature, shift, in_space<Dim>(across.lattice), wanted);
  for (std::size_t axis = 0; axis < Dim && wanted.has(Quantity::point); ++axis) {
    const int k = static_cast<int>(axis);
    geometry.point[axis] = sides[axis] == 0 ? sphere.center[axis] + 0.0
                                            : moved_bound(across.nearest.center[k], steps, k);
  }
  return geometry;
}

template FeatureGeometry geometry_of(const Sphere<2>&, const Box<2>&, const ImageShift&,
                                     const Lattice&, Quantities) noexcept;
template FeatureGeometry geometry_of(const Sphere<3>&, const Box<3>&, const ImageShift&,
                                     const Lattice&, Quantities) noexcept;

}  // namespace abut::exact
