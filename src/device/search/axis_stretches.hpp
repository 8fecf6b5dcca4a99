#pragma once

#include "device/bodies/frame.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/stretch.hpp"
#include "device/executor.hpp"
#include "device/frame.hpp"
#include "device/search/partner_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::device {

/// Divides the axes of a level that is far wider than its elements need into stretches: gaps wider
/// than a cell are closed, so that there are few cells for each element however far apart they are.
/// It sorts the coordinates of each axis once, and must outlive all who look into the level.
template <class Spheres, class E>
class AxisStretches {
  static constexpr int Dim = Spheres::dimensions;

 public:
  AxisStretches(E& executor, const Spheres& elements, const Frame<Dim>& frame, std::uint32_t level)
      : executor_(executor), count_(frame.levels[level].end_slot - frame.levels[level].first_slot) {
    for (int axis = 0; axis < Dim; ++axis) {
      sort(axis, CoordinateInLevel<Spheres>{elements, frame, level, axis, nullptr, nullptr},
           elements.count);
    }
  }

  /// Lays out the narrowest cells whose keys fit. Those in one piece do, and wider ones.
  void lay_out(SizeLevel<Dim>& level, const CellWidths& widths) {
    int too_narrow = -1;
    // By exponents: their quotient may exceed all doubles.
    int fits = std::ilogb(widths.in_one_piece) - std::ilogb(widths.narrowest) + 1;
    while (fits - too_narrow > 1) {
      const int middle = too_narrow + (fits - too_narrow) / 2;
      (divide(level, std::ldexp(widths.narrowest, middle)) ? fits : too_narrow) = middle;
    }
    divide(level, std::ldexp(widths.narrowest, fits));
    for (Sorted& axis : sorted_) axis.coordinates = {};
  }

 private:
  struct Sorted {
    Buffer<std::uint64_t, E> coordinates;
    Buffer<Stretch, E> stretches;
  };

  void sort(int axis, CoordinateInLevel<Spheres> body, std::uint64_t elements) {
    TwinBuffer<std::uint64_t, E> coordinates(executor_, elements);
    TwinBuffer<std::uint32_t, E> numbers(executor_, elements);
    body.coordinates = coordinates.current.data();
    body.numbers = numbers.current.data();
    executor_.for_each(elements, body);
    executor_.sort_by_key(coordinates, numbers, elements, 64);
    sorted_[axis].coordinates.swap(coordinates.current);
  }

  /// Divides all axes by cells of that width; returns whether their keys fit.
  bool divide(SizeLevel<Dim>& level, double cell) {
    level.units_of_one = units_of_cell / cell;
    double keys = 1.0;
    double longest = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      longest = std::max(longest, divide(level, axis, cell));
      keys *= static_cast<double>(level.pitch[axis]);
    }
    return keys <= most_keys_of_level && longest <= cell * most_cells_along_axis;
  }

  /// Returns the length of the longest stretch.
  double divide(SizeLevel<Dim>& level, int axis, double cell) {
    Sorted& sorted = sorted_[axis];
    sorted.stretches = {};
    const std::uint64_t* const coordinates = sorted.coordinates.data();
    Buffer<std::uint64_t, E> before(executor_, count_ + 1);
    executor_.for_each(count_ + 1, StretchBegin{coordinates, count_, cell, before.data()});
    const std::uint64_t stretches = sum_before_each(executor_, before.data(), count_);

    sorted.stretches = Buffer<Stretch, E>(executor_, stretches);
    Stretch* const first = sorted.stretches.data();
    Buffer<double, E> ends(executor_, stretches);
    executor_.for_each(count_,
                       BoundStretch{coordinates, count_, before.data(), first, ends.data()});
    Buffer<std::uint64_t, E> cells(executor_, stretches + 1);
    executor_.for_each(stretches + 1, CellsOfStretch{first, ends.data(), stretches,
                                                     level.units_of_one, cells.data()});
    level.cells[axis] = sum_before_each(executor_, cells.data(), stretches);
    level.pitch[axis] = level.cells[axis] + 1;
    executor_.for_each(stretches, PlaceStretch{cells.data(), first});
    level.axes[axis].stretches = first;
    level.axes[axis].stretch_count = static_cast<std::uint32_t>(stretches);
    return executor_.reduce(stretches, 0.0, StretchLength{first, ends.data()}, Larger{});
  }

  E& executor_;
  std::uint64_t count_;  ///< elements of the level
  Sorted sorted_[Dim];
};

}  // namespace abut::device
