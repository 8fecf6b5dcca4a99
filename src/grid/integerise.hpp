#pragma once

#include "base/detection_context.hpp"
#include "exact/sphere.hpp"
#include "grid/bounds.hpp"
#include "grid/cell_coordinates.hpp"

#include <span>

namespace abut::grid {

/// Maps every element to its cell (book: eq. 3.26, 3.40, 3.59, here counted from 0). Two elements
/// within reach of each other always get equal or adjacent cells on every axis; the proof is in
/// integerise.cpp and docs/derivations/cell_margin.md.
///
/// Throws Error{limit_exceeded} when a cell number would not fit 31 bits.
template <int Dim>
[[nodiscard]] CellCoordinates<Dim> integerise(std::span<const exact::Sphere<Dim>> spheres,
                                              const Bounds<Dim>& bounds, double margin,
                                              base::DetectionContext& context);

}  // namespace abut::grid
