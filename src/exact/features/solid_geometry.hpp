#pragma once

#include "exact/box.hpp"
#include "exact/features/feature_geometry.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

#include <abut/quantity.hpp>

namespace abut::exact {

/// Measures the `wanted` quantities of a sphere and a solid box moved by the shift n of a lattice
/// A.
///
/// Outside, they are those of the nearest point of the box. Where the center lies in the box, its
/// boundary included, they are those of the nearest face: of several the first axis, of two on one
/// axis the lower. Then the distance is minus the depth, the normal points into the box as it does
/// outside of that face, and point and vector are those of the point of the face. So nothing jumps
/// where a center passes through a face.
///
/// The errors are those of FeatureGeometry, and each component of the point is rounded once.
template <int Dim>
[[nodiscard]] FeatureGeometry geometry_of(const Sphere<Dim>& sphere, const Box<Dim>& box,
                                          const ImageShift& shift, const Lattice& lattice,
                                          Quantities wanted) noexcept;

}  // namespace abut::exact
