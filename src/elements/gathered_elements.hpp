#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "exact/elements.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"

#include <abut/element_view.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace abut::elements {

struct GatherSettings {
  std::size_t workers = 1;
  Simd simd = Simd::scalar;  ///< an available level
};

/// The caller's elements as the algorithms read them, one record each, in double. It keeps its
/// memory.
template <int Dim>
struct GatheredElements {
  explicit GatheredElements(base::MemoryMeter& memory)
      : spheres(base::make_array_for_overwrite<exact::Sphere<Dim>>(memory, 0)),
        boxes(base::make_array_for_overwrite<exact::Box<Dim>>(memory, 0)) {}

  [[nodiscard]] exact::Elements<Dim> elements() const noexcept { return {spheres, boxes}; }

  /// Forgets the elements and their memory.
  void give_back_memory() noexcept {
    base::give_back(spheres);
    base::give_back(boxes);
  }

  base::Array<exact::Sphere<Dim>> spheres;
  base::Array<exact::Box<Dim>> boxes;  ///< none where the elements are spheres
  grid::Bounds<Dim> bounds;
  std::vector<grid::Bounds<Dim>> parts;  ///< bounds of what each worker read
};

/// Reads every number once: converts (exactly), checks, packs, finds the bounds. Throws
/// Error{invalid_input} naming the first bad element, its field and the value.
template <int Dim>
void gather(const ElementView& elements, const GatherSettings& settings,
            GatheredElements<Dim>& gathered, base::DetectionContext& context);

/// Reads every number once, as `gather` does, and finds the bounds. What was gathered before is
/// forgotten, and nothing is packed.
template <int Dim>
void bound(const ElementView& elements, const GatherSettings& settings,
           GatheredElements<Dim>& gathered, base::DetectionContext& context);

/// One sphere, unchecked.
template <int Dim>
[[nodiscard]] exact::Sphere<Dim> sphere_at(const ElementView& elements, std::size_t number);

/// One box, unchecked.
template <int Dim>
[[nodiscard]] exact::Box<Dim> box_at(const ElementView& elements, std::size_t number);

}  // namespace abut::elements
