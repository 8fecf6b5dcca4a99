#pragma once

#include "base/detection_context.hpp"
#include "base/sphere_predicate.hpp"
#include "grid/cell_coordinates.hpp"

#include <array>
#include <span>

namespace abut::grid {

/// What the grid must know of the elements; found in the pass that reads them.
template <int Dim>
struct Bounds {
  std::array<double, Dim> lower{};
  std::array<double, Dim> upper{};
  double largest_radius = 0.0;
  double second_largest_radius = 0.0;
};

/// Maps every element to its cell (book: eq. 3.26, 3.40, 3.59, here counted from 0). Two elements
/// within reach of each other always get equal or adjacent cells on every axis; the proof is in
/// integerise.cpp and docs/derivations/cell_margin.md.
///
/// Throws Error{limit_exceeded} when a cell number would not fit 31 bits.
template <int Dim>
[[nodiscard]] CellCoordinates<Dim> integerise(std::span<const base::Sphere<Dim>> spheres,
                                              const Bounds<Dim>& bounds, double margin,
                                              base::DetectionContext& context);

}  // namespace abut::grid
