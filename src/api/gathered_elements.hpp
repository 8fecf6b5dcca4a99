#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "base/sphere_predicate.hpp"
#include "grid/bounds.hpp"

#include <abut/element_view.hpp>
#include <abut/simd.hpp>

#include <span>

namespace abut::api {

struct GatherSettings {
  std::size_t workers = 1;
  Simd simd = Simd::scalar;  ///< an available level
};

/// Packs the caller's elements as the algorithms read them, one record each, in double; returns
/// their bounds. Reads every number once: converts (exactly), checks. Throws Error{invalid_input}
/// naming the first bad element, its field and the value.
template <int Dim>
[[nodiscard]] grid::Bounds<Dim> gather(const ElementView& elements, const GatherSettings& settings,
                                       base::Array<base::Sphere<Dim>>& spheres,
                                       base::DetectionContext& context);

/// One element, unchecked.
template <int Dim>
[[nodiscard]] base::Sphere<Dim> element_at(const ElementView& elements, std::size_t number);

}  // namespace abut::api
