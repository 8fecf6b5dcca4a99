#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/sphere_predicate.hpp"
#include "grid/integerise.hpp"

#include <abut/element_view.hpp>

#include <span>

namespace abut::api {

/// The caller's elements as the algorithms read them: one packed record each, in double.
template <int Dim>
struct GatheredElements {
  base::Array<base::Sphere<Dim>> spheres;
  grid::Bounds<Dim> bounds;
};

/// Reads every number once: converts (exactly), checks, finds the bounds. Throws
/// Error{invalid_input} naming the first bad element, its field and the value.
template <int Dim>
[[nodiscard]] GatheredElements<Dim> gather(const ElementView& elements,
                                           base::DetectionContext& context);

/// One element, unchecked.
template <int Dim>
[[nodiscard]] base::Sphere<Dim> element_at(const ElementView& elements, std::size_t number);

}  // namespace abut::api
