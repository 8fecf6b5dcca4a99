#pragma once

#include "device/bodies/box_columns.hpp"
#include "device/bodies/check.hpp"
#include "device/bodies/joined_columns.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "device/executor.hpp"
#include "elements/reject_element.hpp"

#include <abut/element_view.hpp>
#include <abut/error.hpp>

#include <cstdint>
#include <string>

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

/// Copies one element; for errors, which name it.
template <int Dim, class T, class E>
[[nodiscard]] exact::Sphere<Dim> whole_on_host(E& executor, const SphereColumns<Dim, T>& elements,
                                               std::uint32_t number) {
  exact::Sphere<Dim> sphere{};
  for (int axis = 0; axis < Dim; ++axis) {
    sphere.center[axis] = number_on_host(executor, elements.center[axis], number);
  }
  sphere.radius = elements.has_common_radius() ? elements.common_radius
                                               : number_on_host(executor, elements.radii, number);
  return sphere;
}

template <int Dim, class E>
[[nodiscard]] exact::Box<Dim> whole_on_host(E& executor, const BoxColumns<Dim>& elements,
                                            std::uint32_t number) {
  exact::Box<Dim> box{};
  for (int axis = 0; axis < Dim; ++axis) {
    box.lower[axis] = number_on_host(executor, elements.lower[axis], number);
    box.upper[axis] = number_on_host(executor, elements.upper[axis], number);
  }
  return box;
}

template <class Columns, class E>
[[nodiscard]] auto whole_on_host(E& executor, const Joined<Columns>& elements,
                                 std::uint32_t number) {
  if (elements.is_in_first(number)) return whole_on_host(executor, elements.first, number);
  return whole_on_host(executor, elements.second, number - elements.first.count);
}

template <int Dim, class T>
[[noreturn]] void reject(const SphereColumns<Dim, T>&, std::uint32_t number,
                         const exact::Sphere<Dim>& sphere) {
  elements::reject_element(number, sphere);
}

/// Of two sets the message names the set, too.
template <class Columns, class Element>
[[noreturn]] void reject(const Joined<Columns>& elements, std::uint32_t number,
                         const Element& element) {
  if (!elements.is_of_two_sets) elements::reject_element(number, element);
  const bool is_first = elements.is_in_first(number);
  try {
    elements::reject_element(is_first ? number : number - elements.first.count, element);
  } catch (const Error& error) {
    throw Error(error.code(),
                std::string("in the ") + (is_first ? "first" : "second") + " set, " + error.what());
  }
}

template <int Dim, class T>
void take_common_radius(SphereColumns<Dim, T>& elements, double radius) {
  elements.radii.first = nullptr;
  elements.common_radius = radius;
}
template <class Columns>
void take_common_radius(Joined<Columns>& elements, double radius) {
  take_common_radius(elements.first, radius);
  take_common_radius(elements.second, radius);
}

/// Throws Error{invalid_input} naming the first bad element. Radii that are all equal need not be
/// read again: `elements` has a common one then.
template <class Given, class E>
void require_valid(E& executor, Given& elements, const Extent<Given::dimensions>& extent) {
  if (extent.first_bad != no_element) {
    const auto number = static_cast<std::uint32_t>(extent.first_bad);
    reject(elements, number, whole_on_host(executor, elements, number));
  }
  if constexpr (Given::shape == Shape::sphere) {
    if (extent.smallest_radius == extent.largest_radius) {
      take_common_radius(elements, extent.largest_radius);
    }
  }
}

}  // namespace abut::device
