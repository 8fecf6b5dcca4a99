#include "lattice/check_range.hpp"

#include "base/shortest_text.hpp"
#include "lattice/lattice_unit.hpp"
#include "lattice/orthogonal_cell.hpp"
#include "lattice/turn_downwards.hpp"
#include "lattice/wrapper.hpp"

#include <abut/error.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace abut::lattice {
namespace {

[[noreturn]] void refuse_reach(std::size_t number, double radius, Shape shape) {
  const bool box = shape == Shape::box;
  const double side = std::min(2.0 * radius, std::numeric_limits<double>::max());
  throw Error(ErrorCode::invalid_input,
              "element " + std::to_string(number) +
                  (box ? " has a side of " + base::shortest_text(side)
                       : " has radius = " + base::shortest_text(radius)) +
                  "; it reaches over more than 2147483647 cells: make the lattice vectors longer, "
                  "or " +
                  (box ? "sides" : "radii") + " and margin smaller");
}

}  // namespace

template <int Dim>
void check_range(std::span<const exact::Sphere<Dim>> spheres, const ReducedLattice<Dim>& lattice,
                 double margin, Shape shape, double unit) {
  if (spheres.empty() || lattice.count == 0) return;
  const OrthogonalCell<Dim> orthogonal_cell(lattice, 1.0);
  std::array<bool, Dim> along{};
  along.fill(true);
  grid::Bounds<Dim> bounds;
  for (const exact::Sphere<Dim>& sphere : spheres) bounds.include_center(sphere);
  const double unit_of_result = unit_of_moved(lattice, grid::largest_number(bounds, 0.0) * unit);
  const Wrapper<Dim> wrapper(lattice, orthogonal_cell, along, {shape, unit, unit_of_result});
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    exact::Sphere<Dim> moved = spheres[i];
    for (double& x : moved.center) x *= unit;
    static_cast<void>(wrapper.wrap(moved, i));
  }
  const auto largest =
      std::max_element(spheres.begin(), spheres.end(),
                       [](const auto& a, const auto& b) { return a.radius < b.radius; });
  check_reach<Dim>(static_cast<std::size_t>(largest - spheres.begin()), largest->radius, lattice,
                   margin, shape, unit);
}

template <int Dim>
void check_reach(std::size_t number, double largest_radius, const ReducedLattice<Dim>& lattice,
                 double margin, Shape shape, double unit) {
  const OrthogonalCell<Dim> orthogonal_cell(lattice, 1.0);
  const double reach =
      2.0 * (largest_radius * unit * lattice.scale) + margin * unit * lattice.scale;
  for (std::size_t k = 0; k < orthogonal_cell.count; ++k) {
    if (orthogonal_cell.dual_length[k] * reach <= most_cells_away) continue;
    refuse_reach(number, largest_radius, shape);
  }
}

template <int Dim>
void check_range_as_given(std::span<const exact::Sphere<Dim>> spheres,
                          const exact::Lattice& lattice, double margin, Shape shape) {
  grid::Bounds<Dim> bounds;
  for (const exact::Sphere<Dim>& sphere : spheres) {
    bounds.include_center(sphere);
    bounds.include_radius(sphere.radius);
  }
  const double unit = unit_of<Dim>(lattice, grid::largest_number(bounds, margin));
  ReducedLattice<Dim> reduced(times(lattice, unit));
  if (shape == Shape::box) turn_downwards(reduced);
  check_range<Dim>(spheres, reduced, margin, shape, unit);
}

void refuse_range_of_numbers() {
  throw Error(
      ErrorCode::invalid_input,
      "a lattice vector is shorter than 2^-800, and a position, a length or the margin exceeds "
      "2^720; bring what lies so far out closer, or make the lattice vectors longer");
}

void require_narrow_window(double most_cells) {
  constexpr double widest = 0x1p36;
  if (most_cells <= widest) return;
  throw Error(
      ErrorCode::invalid_input,
      "the lattice vectors differ so much in length that images along the shortest cannot be "
      "told apart for elements so many cells out; move the elements into the cell");
}

void refuse_number_of_images() {
  throw Error(ErrorCode::limit_exceeded,
              "more than 4294967294 periodic images are within reach of the cell; make the lattice "
              "vectors longer, or elements and margin smaller");
}

void refuse_shift(std::size_t i, std::size_t j) {
  throw Error(ErrorCode::invalid_input,
              "elements " + std::to_string(std::min(i, j)) + " and " +
                  std::to_string(std::max(i, j)) +
                  " pair across more than 2147483647 lattice vectors; move them into one cell");
}

template void check_range(std::span<const exact::Sphere<2>>, const ReducedLattice<2>&, double,
                          Shape, double);
template void check_range(std::span<const exact::Sphere<3>>, const ReducedLattice<3>&, double,
                          Shape, double);
template void check_reach(std::size_t, double, const ReducedLattice<2>&, double, Shape, double);
template void check_reach(std::size_t, double, const ReducedLattice<3>&, double, Shape, double);
template void check_range_as_given(std::span<const exact::Sphere<2>>, const exact::Lattice&, double,
                                   Shape);
template void check_range_as_given(std::span<const exact::Sphere<3>>, const exact::Lattice&, double,
                                   Shape);

}  // namespace abut::lattice
