#pragma once

#include "base/host_device.hpp"
#include "device/bodies/check.hpp"
#include "device/bodies/periodic/periodic_elements.hpp"
#include "lattice/cell_extent.hpp"
#include "lattice/orthogonal_cell.hpp"
#include "lattice/wrapper.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace abut::device {

/// Body of a reduction: the coordinates of local element k along the sides of a cell.
template <class Spheres>
struct PlaceInCell {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  lattice::OrthogonalCell<Dim> orthogonal_cell;

  [[nodiscard]] ABUT_HD lattice::CellExtent<Dim> operator()(std::uint64_t k) const noexcept {
    const exact::Sphere<Dim> sphere = elements[static_cast<std::uint32_t>(k)];
    lattice::CellExtent<Dim> extent;
    for (std::size_t side = 0; side < Dim; ++side) {
      if (side >= orthogonal_cell.count) break;
      extent.lower[side] = orthogonal_cell.coordinate(side, sphere.center);
      extent.upper[side] = extent.lower[side];
    }
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      extent.farthest[axis] = std::fabs(sphere.center[axis]);
    }
    return extent;
  }
};

struct JoinCellExtents {
  template <int Dim>
  [[nodiscard]] ABUT_HD lattice::CellExtent<Dim> operator()(
      const lattice::CellExtent<Dim>& a, const lattice::CellExtent<Dim>& b) const noexcept {
    lattice::CellExtent<Dim> joined;
    for (std::size_t k = 0; k < Dim; ++k) {
      joined.lower[k] = std::min(a.lower[k], b.lower[k]);
      joined.upper[k] = std::max(a.upper[k], b.upper[k]);
      joined.farthest[k] = std::max(a.farthest[k], b.farthest[k]);
    }
    return joined;
  }
};

/// Body: moves element k into the cell, and notes by how many cells.
template <class Given>
struct WrapElement {
  static constexpr int Dim = Given::dimensions;

  Given elements;
  lattice::Wrapper<Dim> wrapper;
  double unit;  ///< lattice::unit_of
  PackedCells<std::uint64_t> cells_moved;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    lattice::CellsMoved cells{};
    static_cast<void>(wrap(k, cells));
    cells_moved.set(k, cells);
  }

  [[nodiscard]] ABUT_HD bool wrap(std::uint64_t k, lattice::CellsMoved& cells) const noexcept {
    exact::Sphere<Dim> sphere = elements[static_cast<std::uint32_t>(k)];
    for (double& x : sphere.center) x *= unit;
    return wrapper.wrap_if_near(sphere, cells);
  }
};

/// Body of a reduction: the number of an element that lies too many cells out; else that of none.
template <class Given>
struct FarElement {
  WrapElement<Given> wrapping;

  [[nodiscard]] ABUT_HD std::uint32_t operator()(std::uint64_t k) const noexcept {
    lattice::CellsMoved cells{};
    return wrapping.wrap(k, cells) ? no_element : static_cast<std::uint32_t>(k);
  }
};

/// Body of a reduction: the number of an element of that radius; else that of none.
template <class Given>
struct ElementOfRadius {
  Given elements;
  double radius;

  [[nodiscard]] ABUT_HD std::uint32_t operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    return elements.radius(number) == radius ? number : no_element;
  }
};

}  // namespace abut::device
