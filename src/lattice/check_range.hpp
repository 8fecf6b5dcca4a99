#pragma once

#include "exact/lattice.hpp"
#include "exact/sphere.hpp"
#include "lattice/reduced_lattice.hpp"

#include <abut/element_view.hpp>

#include <cstddef>
#include <span>

namespace abut::lattice {

/// Throws Error{invalid_input} naming the element when one lies more than 2^31 - 1 cells outside of
/// the cell at the origin, or reaches over more cells than that. Image shifts of 32 bits would not
/// do. Boxes are given by their stand-ins (exact::Elements). The lattice is given times `unit`,
/// where that is not 1.
template <int Dim>
void check_range(std::span<const exact::Sphere<Dim>> spheres, const ReducedLattice<Dim>& lattice,
                 double margin, Shape shape, double unit = 1.0);

/// Checks the range with the lattice as given, which is reduced times whatever unit its numbers
/// need.
template <int Dim>
void check_range_as_given(std::span<const exact::Sphere<Dim>> spheres,
                          const exact::Lattice& lattice, double margin, Shape shape);

/// Throws Error{invalid_input} unless images are told apart: where windows of them are far wider
/// than any reach that check_range allows, what is rounded of a long vector covers too many of a
/// short one.
void require_narrow_window(double most_cells);

/// More images are within reach of the cell than can be numbered.
[[noreturn]] void refuse_number_of_images();

/// Throws Error{invalid_input} naming the element of the largest radius where that reaches over
/// more than 2^31 - 1 cells. The lattice is given times `unit`.
template <int Dim>
void check_reach(std::size_t number, double largest_radius, const ReducedLattice<Dim>& lattice,
                 double margin, Shape shape, double unit);

/// Elements i and j pair with a shift beyond 2^31 - 1.
[[noreturn]] void refuse_shift(std::size_t i, std::size_t j);

}  // namespace abut::lattice
