#pragma once

#include "device/bodies/check.hpp"
#include "device/bodies/periodic_spheres.hpp"
#include "device/bodies/size_class.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "device/executor.hpp"
#include "device/levels.hpp"
#include "elements/reject_element.hpp"

#include <cstdint>

namespace abut::device {

template <class T, class E>
[[nodiscard]] double number_on_host(E& executor, const NumberColumn<T>& column, std::uint32_t k) {
  T value{};
  executor.copy_to_host(&value, column.at(k), 1);
  return static_cast<double>(value);
}

template <class E>
[[nodiscard]] double number_on_host(E& executor, const NumberColumn<EitherNumber>& column,
                                    std::uint32_t k) {
  if (column.is_double) {
    return number_on_host(executor, NumberColumn<double>{column.first, column.stride_bytes}, k);
  }
  return number_on_host(executor, NumberColumn<float>{column.first, column.stride_bytes}, k);
}

/// Copies one sphere; for errors, which name it.
template <int Dim, class T, class E>
[[nodiscard]] exact::Sphere<Dim> sphere_on_host(E& executor, const SphereColumns<Dim, T>& elements,
                                                std::uint32_t number) {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) {
    sphere.center[axis] = number_on_host(executor, elements.center[axis], number);
  }
  sphere.radius = elements.has_common_radius() ? elements.common_radius
                                               : number_on_host(executor, elements.radii, number);
  return sphere;
}

/// The number of the element that a sphere of a search is, or is an image of.
template <int Dim, class T, class E>
[[nodiscard]] std::uint32_t element_on_host(E&, const SphereColumns<Dim, T>&, std::uint32_t k) {
  return k;
}
template <int Dim, class T, class E>
[[nodiscard]] std::uint32_t element_on_host(E& executor, const PeriodicSpheres<Dim, T>& spheres,
                                            std::uint32_t k) {
  if (k < spheres.elements.count) return k;
  lattice::Ghost ghost{};
  executor.copy_to_host(&ghost, spheres.ghosts + (k - spheres.elements.count), 1);
  return ghost.element;
}

/// The extent of all elements. Throws Error{invalid_input} naming the first bad one. Radii that are
/// all equal need not be read again: `elements` has a common one then.
template <int Dim, class T, class E>
[[nodiscard]] Extent<Dim> checked_extent(E& executor, SphereColumns<Dim, T>& elements) {
  using Spheres = SphereColumns<Dim, T>;
  // Waits: a bad element is told before anything is done with it, and cells follow the extent.
  const Extent<Dim> extent = executor.reduce(elements.count, Extent<Dim>::of_none(),
                                             ElementExtent<Spheres>{elements}, JoinExtents{});
  if (extent.first_bad != no_element) {
    elements::reject_element(extent.first_bad,
                             sphere_on_host(executor, elements, extent.first_bad));
  }
  if (extent.smallest_radius == extent.largest_radius) {
    elements.radii.first = nullptr;
    elements.common_radius = extent.largest_radius;
  }
  return extent;
}

/// How many elements are of each size.
template <class Spheres, class E>
[[nodiscard]] SizeCounts count_sizes(E& executor, const Spheres& elements,
                                     const Extent<Spheres::dimensions>& extent) {
  Buffer<std::uint64_t, E> bins(executor, size_classes);
  executor.histogram(bins.data(), size_classes, elements.count,
                     SizeClassOf<Spheres>{elements, half_octave_of(extent.largest_radius)});
  // Waits: the host divides the elements into levels.
  SizeCounts counts{};
  executor.copy_to_host(counts.data(), bins.data(), size_classes);
  return counts;
}

}  // namespace abut::device
