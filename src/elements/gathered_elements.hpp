#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "exact/elements.hpp"
#include "grid/bounds.hpp"

#include <abut/element_view.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <vector>

namespace abut::api {

struct GatherSettings {
  std::size_t workers = 1;
  Simd simd = Simd::scalar;  ///< an available level
};

/// The caller's elements as the algorithms read them, one record each, in double. It keeps its
/// memory.
template <int Dim>
struct GatheredElements {
  explicit GatheredElements(base::MemoryMeter& memory)
      : spheres(base::make_array_for_overwrite<base::Sphere<Dim>>(memory, 0)),
        boxes(base::make_array_for_overwrite<base::Box<Dim>>(memory, 0)) {}

  [[nodiscard]] base::Elements<Dim> elements() const noexcept { return {spheres, boxes}; }

  base::Array<base::Sphere<Dim>> spheres;
  base::Array<base::Box<Dim>> boxes;  ///< none where the elements are spheres
  grid::Bounds<Dim> bounds;
  std::vector<grid::Bounds<Dim>> parts;  ///< bounds of what each worker read
};

/// Reads every number once: converts (exactly), checks, packs, finds the bounds. Throws
/// Error{invalid_input} naming the first bad element, its field and the value.
template <int Dim>
void gather(const ElementView& elements, const GatherSettings& settings,
            GatheredElements<Dim>& gathered, base::DetectionContext& context);

/// One sphere, unchecked.
template <int Dim>
[[nodiscard]] base::Sphere<Dim> sphere_at(const ElementView& elements, std::size_t number);

/// One box, unchecked.
template <int Dim>
[[nodiscard]] base::Box<Dim> box_at(const ElementView& elements, std::size_t number);

}  // namespace abut::api
