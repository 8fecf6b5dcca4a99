#pragma once

#include "base/host_device.hpp"
#include "device/bodies/frame.hpp"
#include "device/bodies/sizes.hpp"
#include "device/bodies/sphere_columns.hpp"

#include <abut/element_view.hpp>

#include <cstdint>

namespace abut::device {

/// An element as candidates are tested: its position modulo 2^32 units, and its number. Differences
/// of two positions less than 2^31 apart are exact.
template <int Dim>
struct PlacedRecord {
  std::uint32_t units[Dim];
  std::uint32_t number;
};

/// Body: the key of element k, and its number, which is sorted with it. Along divided axes it is at
/// 0, until PlaceAlongAxis moves it.
template <class Spheres, class Key>
struct PlaceElement {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  Frame<Dim> frame;
  Key* keys;
  std::uint32_t* numbers;
  PlacedRecord<Dim>* records;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const auto number = static_cast<std::uint32_t>(k);
    const exact::Sphere<Dim> sphere = elements[number];
    const SizeLevel<Dim>& level = frame.levels[level_of(frame, sphere.radius)];
    std::uint64_t cell[Dim];
    PlacedRecord<Dim> record{};
    for (int axis = 0; axis < Dim; ++axis) {
      const Axis& along = level.axes[axis];
      const std::uint64_t units =
          along.is_divided()
              ? 0
              : units_along(along, level.units_of_one, sphere.center[axis] * frame.scale);
      cell[axis] = units >> unit_bits;
      record.units[axis] = static_cast<std::uint32_t>(units);
    }
    record.number = number;
    keys[k] = static_cast<Key>(key_of(level, cell));
    numbers[k] = number;
    records[k] = record;
  }
};

/// Body: the record of slot k, once numbers are in the order of keys.
template <int Dim>
struct GatherRecord {
  const std::uint32_t* numbers;
  const PlacedRecord<Dim>* records;
  PlacedRecord<Dim>* sorted;

  ABUT_HD void operator()(std::uint64_t slot) const noexcept {
    sorted[slot] = records[numbers[slot]];
  }
};

/// Body: the size of slot k in units of its own level; of spheres only where radii differ.
template <class Spheres>
struct GatherSize {
  static constexpr int Dim = Spheres::dimensions;

  Spheres elements;
  Frame<Dim> frame;
  const std::uint32_t* numbers;
  SizeOf<Spheres>* sizes;

  ABUT_HD void operator()(std::uint64_t slot) const noexcept {
    const std::uint32_t number = numbers[slot];
    const double radius = elements.radius(number);
    const SizeLevel<Dim>& level = frame.levels[level_of(frame, radius)];
    if constexpr (Spheres::shape == Shape::sphere) {
      sizes[slot] = static_cast<float>(radius * frame.scale * level.units_of_one);
    } else {
      PackedWidths packed{};
      const auto widths = elements.widths(number, frame.scale);
      for (int axis = 0; axis < Dim; ++axis) {
        packed.set(axis, static_cast<std::uint64_t>(widths.along[axis] * level.units_of_one));
      }
      sizes[slot] = packed;
    }
  }
};

}  // namespace abut::device
