#pragma once

#include "base/host_device.hpp"
#include "device/bodies/check.hpp"
#include "device/bodies/periodic/packed_cells.hpp"
#include "device/bodies/periodic/periodic_elements.hpp"
#include "device/bodies/size_class.hpp"
#include "exact/sphere.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/wrapper.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace abut::device {

/// The ghosts that local elements have.
template <class Spheres>
struct GhostsOfLocals {
  static constexpr int Dim = Spheres::dimensions;

  Spheres locals;  ///< and no ghosts yet
  lattice::GhostWindows<Dim> windows;

  /// Calls visit(first, last, image_at) for each row of ghosts of a local element, until it returns
  /// false: image_at(m) tells how the one of number m, from first to last, is moved.
  template <class Visit>
  ABUT_HD void for_each_row(const exact::Sphere<Dim>& local, const Visit& visit) const {
    const std::size_t last_side = windows.of_large.sides() - 1;
    windows.for_each_row(
        local, [&](std::int64_t first, std::int64_t last, const lattice::ImageNumbers& row) {
          return visit(first, last, [&](std::int64_t m) {
            lattice::CellsMoved image{};
            for (std::size_t side = 0; side < 3; ++side) {
              image[side] = static_cast<std::int32_t>(side == last_side ? m : row[side]);
            }
            return image;
          });
        });
  }
};

/// Body: how many ghosts local element k has, not counted beyond a number; none behind the last
/// one.
template <class Spheres>
struct CountGhosts {
  GhostsOfLocals<Spheres> ghosts;
  std::uint64_t most;
  std::uint64_t* counts;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    std::uint64_t count = 0;
    if (k < ghosts.locals.count) {
      ghosts.for_each_row(ghosts.locals[static_cast<std::uint32_t>(k)],
                          [&](std::int64_t first, std::int64_t last, const auto&) {
                            count += static_cast<std::uint64_t>(last - first) + 1;
                            return count < most;
                          });
    }
    counts[k] = count < most ? count : most;
  }
};

/// Body: writes the ghosts of local element k.
template <class Spheres>
struct WriteGhosts {
  GhostsOfLocals<Spheres> ghosts;
  const std::uint64_t* places;  ///< of the first ghost of each element
  PackedGhosts written;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    std::uint64_t next = places[k];
    ghosts.for_each_row(ghosts.locals[number],
                        [&](std::int64_t first, std::int64_t last, const auto& image_at) {
                          for (std::int64_t m = first; m <= last; ++m) {
                            written.elements[next] = number;
                            written.cells.set(next++, image_at(m));
                          }
                          return true;
                        });
  }
};

/// A local element and its ghosts, not counted beyond a number: the box of their centers, and how
/// many they are. Where there are more ghosts none is listed, and nobody asks for the box.
template <class Spheres>
struct LocalWithGhosts {
  static constexpr int Dim = Spheres::dimensions;

  double lower[Dim];
  double upper[Dim];
  std::uint64_t elements = 1;

  ABUT_HD LocalWithGhosts(const GhostsOfLocals<Spheres>& ghosts, const exact::Sphere<Dim>& local,
                          std::uint64_t most) noexcept {
    for (int axis = 0; axis < Dim; ++axis) {
      lower[axis] = local.center[axis];
      upper[axis] = local.center[axis];
    }
    ghosts.for_each_row(local, [&](std::int64_t first, std::int64_t last, const auto& image_at) {
      // Those of a row lie in line.
      include(ghosts.locals, local, image_at(first));
      include(ghosts.locals, local, image_at(last));
      elements += static_cast<std::uint64_t>(last - first) + 1;
      return elements <= most;
    });
  }

 private:
  ABUT_HD void include(const Spheres& locals, const exact::Sphere<Dim>& local,
                       const lattice::CellsMoved& image) noexcept {
    for (int axis = 0; axis < Dim; ++axis) {
      const double x = locals.image_coordinate(local.center[axis], static_cast<std::size_t>(axis),
                                               [&](std::size_t side) { return image[side]; });
      lower[axis] = std::min(lower[axis], x);
      upper[axis] = std::max(upper[axis], x);
    }
  }
};

/// Body of a reduction: the extent of local element k and its ghosts.
template <class Spheres>
struct ExtentWithGhosts {
  static constexpr int Dim = Spheres::dimensions;

  GhostsOfLocals<Spheres> ghosts;
  std::uint64_t most;

  [[nodiscard]] ABUT_HD Extent<Dim> operator()(std::uint64_t k) const noexcept {
    const exact::Sphere<Dim> local = ghosts.locals[static_cast<std::uint32_t>(k)];
    const LocalWithGhosts<Spheres> all(ghosts, local, most);
    Extent<Dim> extent = extent_of_element<Spheres>(local);
    for (int axis = 0; axis < Dim; ++axis) {
      extent.lower[axis] = all.lower[axis];
      extent.upper[axis] = all.upper[axis];
    }
    if (all.elements > 1) extent.second_largest_radius = local.radius;
    return extent;
  }
};

/// Body of join_by_class: local element k and its ghosts, as SizeClassOf has one alone.
template <class Spheres>
struct SizeClassWithGhosts {
  static constexpr int Dim = Spheres::dimensions;

  GhostsOfLocals<Spheres> ghosts;
  std::uint64_t most;
  const Extent<Dim>* all;  ///< of locals and ghosts

  [[nodiscard]] ABUT_HD OfSizeClass<Dim> operator()(std::uint64_t k) const noexcept {
    OfSizeClass<Dim> item;
    const exact::Sphere<Dim> local = ghosts.locals[static_cast<std::uint32_t>(k)];
    const LocalWithGhosts<Spheres> elements(ghosts, local, most);
    item.number = size_class_of(local.radius, half_octave_of(all->largest_radius));
    item.numbers.elements = elements.elements;
    item.numbers.include_center(elements.lower);
    item.numbers.include_center(elements.upper);
    item.numbers.include_radius(local.radius);
    return item;
  }
};

}  // namespace abut::device
