#pragma once

#include "base/host_device.hpp"
#include "base/opposite_shift.hpp"
#include "device/bodies/filter_verdict.hpp"
#include "device/bodies/joined_columns.hpp"
#include "device/bodies/pair_rule.hpp"
#include "device/bodies/periodic/packed_cells.hpp"
#include "exact/box.hpp"
#include "exact/far_image.hpp"
#include "exact/lattice.hpp"
#include "lattice/ghost_windows.hpp"
#include "lattice/wrap_rules.hpp"
#include "lattice/wrapper.hpp"

#include <abut/element_view.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::device {

/// How elements of a periodic domain are moved, and what the shifts of pairs are then
/// (docs/derivations/periodic_images.md).
template <int Dim>
struct ImageMap {
  lattice::Wrapper<Dim> wrapper;
  lattice::SideSteps<Dim> steps;  ///< times all units
  double given_unit;              ///< lattice::unit_of
  double unit;                    ///< lattice::unit_of_moved
  double size_cut;                ///< lattice::GhostWindows::cut, times all units
  bool has_large;                 ///< whether some elements are as large as that
  bool shifts_always_fit;         ///< into 32 bits
  /// A step along a side in terms of the lattice as given, by axis.
  std::int64_t shift_of_side[Dim][3];
  exact::Lattice given;
};

/// The elements of one or two sets in a periodic domain as a search in open space takes them: the
/// elements themselves in about one cell, the locals, whose numbers are theirs, and behind them the
/// ghosts; in an open domain the elements where they are. Nothing but the numbers of a ghost is
/// stored: positions are computed from the caller's whenever they are asked for, always by the same
/// sequence.
template <class GivenElements, class Ghosts = PackedGhosts>
struct PeriodicElements {
  using Given = GivenElements;
  using Ghost = typename Ghosts::Ghost;
  static constexpr int Dim = Given::dimensions;
  static constexpr int dimensions = Dim;
  static constexpr Shape shape = Given::shape;

  Given elements;
  ImageMap<Dim> map;
  PackedCells<std::uint64_t> cells_moved;  ///< of each element; none where none was moved
  Ghosts ghosts;
  std::uint32_t count;  ///< locals and ghosts
  RuleView rule = {};   ///< of one set's or of two sets' elements

  [[nodiscard]] ABUT_HD const Given& given() const noexcept { return elements; }
  [[nodiscard]] ABUT_HD bool has_common_radius() const noexcept {
    return elements.has_common_radius();
  }

  [[nodiscard]] ABUT_HD bool is_ghost(std::uint32_t k) const noexcept {
    return k >= elements.count;
  }

  [[nodiscard]] ABUT_HD std::uint32_t element_of(std::uint32_t k) const noexcept {
    return k < elements.count ? k : ghosts.element(k - elements.count);
  }

  [[nodiscard]] ABUT_HD double radius(std::uint32_t k) const noexcept {
    return elements.radius(element_of(k)) * map.given_unit * map.unit;
  }

  [[nodiscard]] ABUT_HD exact::Sphere<Dim> operator[](std::uint32_t k) const noexcept {
    exact::Sphere<Dim> sphere{};
    for (int axis = 0; axis < Dim; ++axis) sphere.center[axis] = coordinate(k, axis);
    sphere.radius = radius(k);
    return sphere;
  }

  [[nodiscard]] ABUT_HD double coordinate(std::uint32_t k, int axis) const noexcept {
    const std::uint32_t element = element_of(k);
    const auto along = static_cast<std::size_t>(axis);
    lattice::CellsMoved cells{};
    if (!cells_moved.is_empty()) cells = cells_moved.all(element);
    const double given = elements.coordinate(element, axis) * map.given_unit;
    const double coordinate = map.wrapper.moved(given, along, cells);
    if (k < elements.count) return coordinate;
    return image_coordinate(coordinate, along, [&](std::size_t side) {
      return ghosts.image(k - elements.count, side);
    });
  }

  /// Where the image of a local element lies that is moved by number_of(side) cells along each
  /// side, by the sequence that is the same wherever it is asked for.
  template <class NumberOf>
  [[nodiscard]] ABUT_HD double image_coordinate(double coordinate, std::size_t axis,
                                                const NumberOf& number_of) const noexcept {
    for (std::size_t side = 0; side < Dim; ++side) {
      coordinate += static_cast<double>(number_of(side)) * map.steps[side][axis];
    }
    return coordinate;
  }

  /// The element itself. The upper end of a box goes with its lower corner, and is not rounded
  /// where that was not moved.
  [[nodiscard]] ABUT_HD auto whole(std::uint32_t k) const noexcept {
    if constexpr (shape == Shape::sphere) {
      return (*this)[k];
    } else {
      const double unit = map.given_unit * map.unit;
      exact::Box<Dim> box = elements.whole(element_of(k));
      for (int axis = 0; axis < Dim; ++axis) {
        const double lower = box.lower[axis] * unit;
        const double upper = box.upper[axis] * unit;
        box.lower[axis] = coordinate(k, axis);
        box.upper[axis] = box.lower[axis] == lower ? upper : box.lower[axis] + (upper - lower);
      }
      return box;
    }
  }

  /// The widths of a box along the axes, times a scale: of the numbers as they are given.
  struct Widths {
    double along[Dim];
  };
  [[nodiscard]] ABUT_HD Widths widths(std::uint32_t k, double scale) const noexcept {
    const double unit = map.given_unit * map.unit * scale;
    const exact::Box<Dim> box = elements.whole(element_of(k));
    Widths widths{};
    for (int axis = 0; axis < Dim; ++axis) {
      widths.along[axis] = box.upper[axis] * unit - box.lower[axis] * unit;
    }
    return widths;
  }

  [[nodiscard]] ABUT_HD bool is_as_given(const ContactPair& pair) const noexcept {
    if (pair.second >= elements.count) return false;
    if (cells_moved.is_empty()) return true;
    bool is_same = true;
    for (std::size_t side = 0; side < Dim; ++side) {
      is_same = is_same && cells_moved.at(pair.first, side) == cells_moved.at(pair.second, side);
    }
    return is_same;
  }

  [[nodiscard]] ABUT_HD bool decides_all() const noexcept { return map.shifts_always_fit; }

  /// Whether the elements that a pair stands for may be one: none of one of two sets, and none that
  /// the rule denies.
  [[nodiscard]] ABUT_HD bool may_pair(const ContactPair& pair) const noexcept {
    const std::uint32_t second = element_of(pair.second);
    return elements.may_pair(pair.first, second) && rule.allows(elements.named(pair.first, second));
  }

  /// Two ghosts, and a local element with a ghost that does not count for it, are found elsewhere,
  /// too. Where shifts may be too large, all pairs are decided one by one, and only then asked
  /// whether they may be one: a shift that is too large is refused in any case.
  [[nodiscard]] ABUT_HD FilterVerdict counted(std::uint32_t one, std::uint32_t other,
                                              FilterVerdict verdict) const noexcept {
    const ContactPair pair = one < other ? ContactPair{one, other} : ContactPair{other, one};
    if (pair.first >= elements.count) return FilterVerdict::apart;
    if (map.has_large && pair.second >= elements.count &&
        !counts(pair.first, pair.second - elements.count)) {
      return FilterVerdict::apart;
    }
    if (!map.shifts_always_fit && !is_as_given(pair)) return FilterVerdict::doubtful;
    if (!may_pair(pair)) return FilterVerdict::apart;
    return map.shifts_always_fit ? verdict : FilterVerdict::doubtful;
  }

  /// The steps along a side from the image that a pair's second element stands for to its own
  /// place, beside that of the first: Images::numbers_between.
  [[nodiscard]] ABUT_HD std::int64_t steps_along(const ContactPair& pair,
                                                 std::size_t side) const noexcept {
    std::int64_t steps = 0;
    if (pair.second >= elements.count) steps = ghosts.image(pair.second - elements.count, side);
    if (!cells_moved.is_empty()) {
      steps += cells_moved.at(pair.first, side);
      steps -= cells_moved.at(element_of(pair.second), side);
    }
    return steps;
  }

  /// The shift of a pair, where it fits into 32 bits: what overflows on the way comes back.
  [[nodiscard]] ABUT_HD ImageShift shift_of(const ContactPair& pair) const noexcept {
    std::uint64_t shift[3] = {0, 0, 0};
    for (std::size_t side = 0; side < Dim; ++side) {
      const auto steps = static_cast<std::uint64_t>(steps_along(pair, side));
      for (int axis = 0; axis < 3; ++axis) {
        shift[axis] += steps * static_cast<std::uint64_t>(map.shift_of_side[side][axis]);
      }
    }
    return {static_cast<std::int32_t>(shift[0]), static_cast<std::int32_t>(shift[1]),
            static_cast<std::int32_t>(shift[2])};
  }

  /// The shift of any pair.
  [[nodiscard]] ABUT_HD exact::FarShift far_shift_of(const ContactPair& pair) const noexcept {
    exact::FarShift shift{};
    for (std::size_t side = 0; side < Dim; ++side) {
      const exact::Int128 steps = steps_along(pair, side);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        shift[axis] += steps * map.shift_of_side[side][axis];
      }
    }
    return shift;
  }

 private:
  /// Images::counts
  [[nodiscard]] ABUT_HD bool counts(std::uint32_t local, std::uint32_t ghost) const noexcept {
    const bool is_large = radius(local) >= map.size_cut;
    if (radius(ghosts.element(ghost)) < map.size_cut) return !is_large;
    return !is_large || ghosts.is_positive(ghost);
  }
};

template <int Dim>
using PeriodicSpheres = PeriodicElements<JoinedColumns<Dim>>;

/// Elements that are checked pair by pair: none is moved, and ghosts are the images that were found
/// within reach, by vectors of the reduced basis, as often as it takes from elements far out.
template <class Given>
using CheckedElements = PeriodicElements<Given, ImagesAsGhosts>;

}  // namespace abut::device
