#pragma once

#include "base/host_device.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/ordered_double.hpp"
#include "device/bodies/place.hpp"
#include "device/bodies/sphere_columns.hpp"

#include <cstdint>

namespace abut::device {

/// The number of the last of `count` stretches that begins at or before a coordinate; 0 if none
/// does. start(k) is where one begins.
template <class Begin>
[[nodiscard]] ABUT_HD inline std::uint32_t stretch_of(std::uint32_t count, double scaled,
                                                      const Begin& start) noexcept {
  std::uint32_t first = 0;
  while (count > 1) {
    const std::uint32_t half = count / 2;
    if (start(first + half) <= scaled) {
      first += half;
      count -= half;
    } else {
      count = half;
    }
  }
  return first;
}

/// A cell stays empty between two stretches: elements of two are never in adjacent cells.
inline constexpr std::uint64_t cells_between_stretches = 1;

/// Body: 1 if element k belongs to a level, else 0.
template <class Spheres>
struct CountInLevel {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  Frame<Dim> frame;
  std::uint32_t level;
  std::uint32_t* counts;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    counts[k] = level_of(frame, elements.radius(static_cast<std::uint32_t>(k))) == level ? 1 : 0;
  }
};

/// Body: the scaled coordinate of element k on one axis, to be sorted, if it belongs to a level.
template <class Spheres>
struct CoordinateInLevel {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  Frame<Dim> frame;
  std::uint32_t level;
  int axis;
  const std::uint32_t* places;  ///< of its elements; null where it has all
  std::uint64_t* coordinates;
  std::uint32_t* numbers;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    if (level_of(frame, elements.radius(number)) != level) return;
    const std::uint64_t place = places == nullptr ? k : places[k];
    coordinates[place] = ordered_bits(elements.coordinate(number, axis) * frame.scale);
    numbers[place] = number;
  }
};

/// The coordinates of all elements of a level along an axis, in ascending order, and where
/// stretches begin among them.
struct AxisOfStretches {
  const std::uint64_t* coordinates;  ///< ordered_bits, scaled
  std::uint32_t count;
  const std::uint32_t* begins;  ///< of each stretch
  std::uint32_t stretch_count;
  const std::uint64_t* first_cells;  ///< of each stretch

  [[nodiscard]] ABUT_HD double start(std::uint32_t stretch) const noexcept {
    return double_of(coordinates[begins[stretch]]);
  }
  /// The last coordinate in a stretch.
  [[nodiscard]] ABUT_HD double end(std::uint32_t stretch) const noexcept {
    return double_of(coordinates[(stretch + 1 < stretch_count ? begins[stretch + 1] : count) - 1]);
  }

  /// Where one of the elements lies, in units.
  [[nodiscard]] ABUT_HD std::uint64_t units_along(double units_of_one,
                                                  double scaled) const noexcept {
    const std::uint32_t stretch =
        stretch_of(stretch_count, scaled, [this](std::uint32_t k) { return start(k); });
    return (first_cells[stretch] << unit_bits) +
           static_cast<std::uint64_t>((scaled - start(stretch)) * units_of_one);
  }
};

/// Body: 1 where a stretch begins at sorted coordinate k, else 0; 0 behind the last.
struct StretchBegin {
  const std::uint64_t* coordinates;
  std::uint64_t count;
  double widest_gap;
  std::uint32_t* begins;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (k == 0 || k == count) {
      begins[k] = k < count ? 1 : 0;
    } else {
      begins[k] = double_of(coordinates[k]) - double_of(coordinates[k - 1]) > widest_gap ? 1 : 0;
    }
  }
};

/// Body: notes the stretch that begins at coordinate k, if one does.
struct WriteBegin {
  const std::uint32_t* before;  ///< stretches that begin before each coordinate, and in all
  std::uint32_t* begins;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (before[k + 1] != before[k]) begins[before[k]] = static_cast<std::uint32_t>(k);
  }
};

/// Body: the length of stretch k.
struct StretchLength {
  AxisOfStretches axis;

  [[nodiscard]] ABUT_HD double operator()(std::uint64_t k) const noexcept {
    const auto stretch = static_cast<std::uint32_t>(k);
    return axis.end(stretch) - axis.start(stretch);
  }
};

/// Body: how many cells stretch k takes, the empty ones behind it included; none behind the last.
struct CellsOfStretch {
  AxisOfStretches axis;
  double units_of_one;
  std::uint64_t* cells;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (k == axis.stretch_count) {
      cells[k] = 0;
      return;
    }
    const auto units = static_cast<std::uint64_t>(StretchLength{axis}(k)*units_of_one);
    cells[k] = (units >> unit_bits) + 1 + cells_between_stretches;
  }
};

/// Body: moves element k along a divided axis, if it belongs to the level: its record is at 0 on
/// that axis, and its key one of the first cell.
template <class Spheres, class Key>
struct PlaceAlongAxis {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  Frame<Dim> frame;
  std::uint32_t level;
  int axis;
  AxisOfStretches divided;
  std::uint64_t keys_of_cell;
  Key* keys;
  PlacedRecord<Dim>* records;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    if (level_of(frame, elements.radius(number)) != level) return;
    const std::uint64_t units = divided.units_along(
        frame.levels[level].units_of_one, elements.coordinate(number, axis) * frame.scale);
    keys[k] += static_cast<Key>((units >> unit_bits) * keys_of_cell);
    records[k].units[axis] = static_cast<std::uint32_t>(units);
  }
};

}  // namespace abut::device
