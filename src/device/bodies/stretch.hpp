#pragma once

#include "base/host_device.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/sphere_columns.hpp"

#include <bit>
#include <cstdint>

namespace abut::device {

/// A cell stays empty between two stretches: elements of two are never in adjacent cells.
inline constexpr std::uint64_t cells_between_stretches = 1;

/// Whole numbers in the order of the doubles that they stand for.
[[nodiscard]] ABUT_HD inline std::uint64_t ordered_bits(double value) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

[[nodiscard]] ABUT_HD inline double double_of(std::uint64_t ordered) noexcept {
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return std::bit_cast<double>((ordered & sign) != 0 ? ordered ^ sign : ~ordered);
}

/// Body: the scaled coordinate of element k on one axis, to be sorted; those of other levels come
/// behind all.
template <class Spheres>
struct CoordinateInLevel {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  Frame<Dim> frame;
  std::uint32_t level;
  int axis;
  std::uint64_t* coordinates;
  std::uint32_t* numbers;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    const bool is_here = level_of(frame, elements.radius(number)) == level;
    coordinates[k] =
        is_here ? ordered_bits(elements.coordinate(number, axis) * frame.scale) : ~std::uint64_t{0};
    numbers[k] = number;
  }
};

/// Body: 1 where a stretch begins at sorted coordinate k, else 0; 0 behind the last.
struct StretchBegin {
  const std::uint64_t* coordinates;
  std::uint64_t count;
  double widest_gap;
  std::uint64_t* begins;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (k == 0 || k == count) {
      begins[k] = k < count ? 1 : 0;
    } else {
      begins[k] = double_of(coordinates[k]) - double_of(coordinates[k - 1]) > widest_gap ? 1 : 0;
    }
  }
};

/// Body: writes the start of the stretch that begins at coordinate k, and the end of the one
/// before.
struct BoundStretch {
  const std::uint64_t* coordinates;
  std::uint64_t count;
  const std::uint64_t* before;  ///< stretches that begin before each coordinate, and in all
  Stretch* stretches;
  double* ends;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const double coordinate = double_of(coordinates[k]);
    if (k + 1 == count) ends[before[count] - 1] = coordinate;
    if (before[k + 1] == before[k]) return;
    stretches[before[k]].start = coordinate;
    if (k > 0) ends[before[k] - 1] = double_of(coordinates[k - 1]);
  }
};

/// Body: the length of stretch k.
struct StretchLength {
  const Stretch* stretches;
  const double* ends;

  [[nodiscard]] ABUT_HD double operator()(std::uint64_t k) const noexcept {
    return ends[k] - stretches[k].start;
  }
};

/// Body: how many cells stretch k takes, the empty ones behind it included.
struct CellsOfStretch {
  const Stretch* stretches;
  const double* ends;
  std::uint64_t count;
  double units_of_one;
  std::uint64_t* cells;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (k == count) {
      cells[k] = 0;
      return;
    }
    const double length = ends[k] - stretches[k].start;
    const auto units = static_cast<std::uint64_t>(length * units_of_one);
    cells[k] = (units >> unit_bits) + 1 + cells_between_stretches;
  }
};

/// Body: the first cell of stretch k.
struct PlaceStretch {
  const std::uint64_t* cells_before;
  Stretch* stretches;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    stretches[k].first_cell = cells_before[k];
  }
};

}  // namespace abut::device
