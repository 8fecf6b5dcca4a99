#pragma once

#include "base/host_device.hpp"
#include "exact/sphere.hpp"

namespace abut::exact {

/// distance - (r_a + r_b) by one fixed sequence of operations, with the sign that the exact
/// predicate gives: <= 0 exactly if the spheres touch. Never overflows to infinity.
template <int Dim>
[[nodiscard]] ABUT_HD double gap(const Sphere<Dim>& a, const Sphere<Dim>& b) noexcept;

}  // namespace abut::exact
