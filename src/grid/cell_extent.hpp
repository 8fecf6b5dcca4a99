#pragma once

#include "base/sphere_predicate.hpp"
#include "grid/bounds.hpp"
#include "grid/reduced_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace abut::grid {

/// The fractional coordinates that occur among some elements, and their farthest coordinates.
template <int Dim>
struct CellExtent {
  std::array<double, Dim> lower = filled(std::numeric_limits<double>::infinity());
  std::array<double, Dim> upper = filled(-std::numeric_limits<double>::infinity());
  std::array<double, Dim> farthest{};  ///< on each axis of space, of either sign

  void include(std::size_t k, double fraction) noexcept {
    lower[k] = std::min(lower[k], fraction);
    upper[k] = std::max(upper[k], fraction);
  }

  void include(const base::Sphere<Dim>& sphere, const ReducedLattice<Dim>& lattice,
               double scale) noexcept {
    for (std::size_t k = 0; k < lattice.count; ++k) {
      include(k, lattice.fraction(k, sphere.center, scale));
    }
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      farthest[axis] = std::max(farthest[axis], std::fabs(sphere.center[axis]));
    }
  }

  void include(const CellExtent& others) noexcept {
    for (std::size_t k = 0; k < Dim; ++k) {
      lower[k] = std::min(lower[k], others.lower[k]);
      upper[k] = std::max(upper[k], others.upper[k]);
      farthest[k] = std::max(farthest[k], others.farthest[k]);
    }
  }

 private:
  static constexpr std::array<double, Dim> filled(double value) noexcept {
    std::array<double, Dim> result{};
    result.fill(value);
    return result;
  }
};

/// Where each basis vector lies along one axis, the box of the elements has the extent: fractions
/// ascend or descend with the coordinate, in rounded numbers too.
template <int Dim>
[[nodiscard]] bool is_aligned(const ReducedLattice<Dim>& lattice) noexcept {
  for (std::size_t k = 0; k < lattice.count; ++k) {
    if (std::count(lattice.dual[k].begin(), lattice.dual[k].end(), 0.0) != Dim - 1) return false;
  }
  return true;
}

template <int Dim>
[[nodiscard]] CellExtent<Dim> extent_of(const Bounds<Dim>& bounds,
                                        const ReducedLattice<Dim>& lattice) noexcept {
  CellExtent<Dim> extent;
  for (const auto& corner : {bounds.lower, bounds.upper}) {
    base::Sphere<Dim> sphere{};
    std::copy(corner.begin(), corner.end(), sphere.center);
    extent.include(sphere, lattice, lattice.scale);
  }
  return extent;
}

}  // namespace abut::grid
