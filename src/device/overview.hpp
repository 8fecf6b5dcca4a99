#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/size_class.hpp"
#include "device/executor.hpp"
#include "device/levels.hpp"

#include <abut/element_view.hpp>

#include <cstdint>

namespace abut::device {

/// What the host must know of elements before they are divided into levels and cells: their extent,
/// and what those of each size class come to. Where all are of one size no class has elements.
template <int Dim>
struct Overview {
  Extent<Dim> all;
  SizeClassNumbers<Dim> classes[size_classes];
};

/// How many elements are of each size.
template <int Dim>
[[nodiscard]] SizeCounts counts_of(const Overview<Dim>& overview) noexcept {
  SizeCounts counts{};
  for (std::uint32_t k = 0; k < size_classes; ++k) counts[k] = overview.classes[k].elements;
  return counts;
}

/// The extent of the elements of a class, of one or more. A second one is as large as the largest,
/// as far as is known here: cells of a level may be wider than they need be, by less than a fifth,
/// and up to twice as wide for the last class, which has no lower end.
template <Shape shape, int Dim>
[[nodiscard]] Extent<Dim> extent_of_class(const SizeClassNumbers<Dim>& numbers) noexcept {
  Extent<Dim> extent = Extent<Dim>::of_none();
  for (int axis = 0; axis < Dim; ++axis) {
    extent.lower[axis] = double_of(numbers.least[axis]);
    extent.upper[axis] = -double_of(numbers.least[Dim + axis]);
  }
  extent.largest_radius = -double_of(numbers.least[2 * Dim]);
  extent.smallest_radius = extent.largest_radius;
  if (numbers.elements > 1 || shape == Shape::box) {
    extent.second_largest_radius = extent.largest_radius;
  }
  return extent;
}

/// Writes the overview of elements to memory of the device. Waits for nothing.
template <class Spheres, class E>
void write_overview(E& executor, const Spheres& elements, Overview<Spheres::dimensions>* overview) {
  executor.reduce_into(&overview->all, elements.count, Extent<Spheres::dimensions>::of_none(),
                       ElementExtent<Spheres>{elements}, JoinExtents{});
  const std::uint64_t of_sizes = elements.has_common_radius() ? 0 : elements.count;
  executor.join_by_class(overview->classes, of_sizes,
                         SizeClassOf<Spheres>{elements, &overview->all});
}

}  // namespace abut::device
