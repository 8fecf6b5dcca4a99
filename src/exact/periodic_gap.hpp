#pragma once

#include "base/host_device.hpp"
#include "exact/lattice.hpp"
#include "exact/sphere.hpp"

namespace abut::exact {

/// |x_a - (x_b + n A)| - (r_a + r_b) by one fixed sequence of operations, with the sign that the
/// exact predicate gives: <= 0 exactly if the spheres touch. Never overflows to infinity. Without a
/// shift it has the bits of the gap in open space.
template <int Dim>
[[nodiscard]] ABUT_HD double gap(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                 const ImageShift& shift, const Lattice& lattice) noexcept;

}  // namespace abut::exact
