#pragma once

#include "base/array.hpp"
#include "base/detection_context.hpp"
#include "exact/box.hpp"
#include "exact/simplices/simplex.hpp"
#include "walls/vertex_numbers.hpp"

#include <abut/simplex_contacts.hpp>

#include <cstddef>

namespace abut::simplices {

/// The caller's simplices as they are decided, one record each, in double, and the boxes around
/// them.
template <int Dim>
struct GatheredSimplices {
  GatheredSimplices(const SimplexView& view, base::MemoryMeter& memory)
      : numbers(view.cells(), view.vertices().size()),
        simplices(base::make_array_for_overwrite<exact::Simplex<Dim>>(memory, view.size())),
        boxes(base::make_array_for_overwrite<exact::Box<Dim>>(memory, view.size())) {}

  walls::VertexNumbers numbers;
  base::Array<exact::Simplex<Dim>> simplices;
  base::Array<exact::Box<Dim>> boxes;
};

/// One simplex. Throws Error{invalid_input} for a vertex that does not exist or is not finite.
template <int Dim>
[[nodiscard]] exact::Simplex<Dim> simplex_at(const SimplexView& view, std::size_t number);

/// Reads and checks all simplices, and finds their boxes. Throws as simplex_at does, for the first
/// bad one.
template <int Dim>
[[nodiscard]] GatheredSimplices<Dim> gather(const SimplexView& view, std::size_t workers,
                                            base::DetectionContext& context);

}  // namespace abut::simplices
