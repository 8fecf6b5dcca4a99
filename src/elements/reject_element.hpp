#pragma once

#include "exact/box.hpp"
#include "exact/sphere.hpp"

#include <cstddef>

namespace abut::elements {

/// Throws Error{invalid_input} that names what is wrong with a sphere: x before y before z before
/// the radius. The sphere must be wrong.
template <int Dim>
[[noreturn]] void reject_element(std::size_t number, const exact::Sphere<Dim>& sphere);

/// Throws Error{invalid_input} that names the first fault of a box: looks at the lower corner, the
/// upper one, then their order. The box must be wrong.
template <int Dim>
[[noreturn]] void reject_element(std::size_t number, const exact::Box<Dim>& box);

}  // namespace abut::elements
