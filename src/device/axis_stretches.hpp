#pragma once

#include "device/bodies/frame.hpp"
#include "device/bodies/larger.hpp"
#include "device/bodies/stretch.hpp"
#include "device/executor.hpp"
#include "device/frame.hpp"
#include "device/partner_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace abut::device {

/// Divides the axes of a domain that is far wider than its elements need into stretches: gaps wider
/// than a cell are closed, so that there are a few cells for each element however far apart they
/// are. It sorts the coordinates of each axis once.
template <int Dim, class T, class E>
class AxisStretches {
 public:
  AxisStretches(E& executor, const SphereColumns<Dim, T>& elements, double scale)
      : executor_(executor), elements_(elements) {
    for (int axis = 0; axis < Dim; ++axis) sort(axis, scale);
  }

  /// Finds the narrowest cells whose keys fit, between a width that may do and one that does.
  void choose_cell(double narrowest, double wide_enough) {
    int too_narrow = -1;
    int fits = static_cast<int>(std::ceil(std::log2(wide_enough / narrowest)));
    while (fits - too_narrow > 1) {
      const int middle = too_narrow + (fits - too_narrow) / 2;
      (divide(std::ldexp(narrowest, middle)) ? fits : too_narrow) = middle;
    }
    divide(std::ldexp(narrowest, fits));
    for (Sorted& axis : sorted_) axis.coordinates = {};
  }

  [[nodiscard]] StretchedAxes<Dim> axes() const noexcept { return axes_; }

 private:
  struct Sorted {
    Buffer<std::uint64_t, E> coordinates;
    Buffer<Stretch, E> stretches;
  };

  void sort(int axis, double scale) {
    const std::uint64_t count = elements_.count;
    TwinBuffer<std::uint64_t, E> coordinates(executor_, count);
    TwinBuffer<std::uint32_t, E> numbers(executor_, count);
    executor_.for_each(count,
                       CoordinateOf<Dim, T>{elements_, axis, scale, coordinates.current.data(),
                                            numbers.current.data()});
    executor_.sort_by_key(coordinates, numbers, count, 64);
    sorted_[axis].coordinates.swap(coordinates.current);
  }

  /// Divides all axes by cells of that width; returns whether their keys fit.
  bool divide(double cell) {
    axes_.cell = cell;
    axes_.longest = 0.0;
    double keys = 1.0;
    for (int axis = 0; axis < Dim; ++axis) {
      keys *= static_cast<double>(divide(axis, cell)) + 1.0;
    }
    return keys <= most_keys_of_level && axes_.longest <= cell * most_cells_along_axis;
  }

  /// Returns the number of cells of the axis.
  std::uint64_t divide(int axis, double cell) {
    Sorted& sorted = sorted_[axis];
    sorted.stretches = {};
    const std::uint64_t count = elements_.count;
    const std::uint64_t* const coordinates = sorted.coordinates.data();
    Buffer<std::uint64_t, E> before(executor_, count + 1);
    executor_.for_each(count + 1, BeginsStretch{coordinates, count, cell, before.data()});
    const std::uint64_t stretches = sum_before_each(executor_, before.data(), count);

    sorted.stretches = Buffer<Stretch, E>(executor_, stretches);
    Buffer<double, E> ends(executor_, stretches);
    executor_.for_each(count, BoundStretch{coordinates, count, before.data(),
                                           sorted.stretches.data(), ends.data()});
    const double longest = executor_.reduce(
        stretches, 0.0, StretchLength{sorted.stretches.data(), ends.data()}, Larger{});
    axes_.longest = std::max(axes_.longest, longest);

    Buffer<std::uint64_t, E> cells(executor_, stretches + 1);
    executor_.for_each(stretches + 1,
                       CellsOfStretch{sorted.stretches.data(), ends.data(), stretches,
                                      units_of_cell / cell, cells.data()});
    const std::uint64_t all = sum_before_each(executor_, cells.data(), stretches);
    executor_.for_each(stretches, PlaceStretch{cells.data(), sorted.stretches.data()});

    axes_.stretches[axis] = sorted.stretches.data();
    axes_.counts[axis] = static_cast<std::uint32_t>(stretches);
    executor_.copy_to_host(&axes_.last[axis], sorted.stretches.data() + stretches - 1, 1);
    return all;
  }

  E& executor_;
  SphereColumns<Dim, T> elements_;
  Sorted sorted_[Dim];
  StretchedAxes<Dim> axes_;
};

}  // namespace abut::device
