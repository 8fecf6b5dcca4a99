#pragma once

#include "device/bodies/joined_columns.hpp"
#include "device/bodies/sphere_columns.hpp"

#include <abut/element_view.hpp>

#include <cstdint>
#include <type_traits>

namespace abut::device {

template <class T>
[[nodiscard]] NumberColumn<T> column_of(const ElementView::Numbers& numbers, Precision precision) {
  if constexpr (std::is_same_v<T, EitherNumber>) {
    return {numbers.first, numbers.stride_bytes, precision == Precision::float64};
  } else {
    return {numbers.first, numbers.stride_bytes};
  }
}

/// The columns of a view of spheres of Dim dimensions and numbers of type T.
template <int Dim, class T>
[[nodiscard]] SphereColumns<Dim, T> columns_of(const ElementView& spheres) {
  SphereColumns<Dim, T> columns{};
  for (int axis = 0; axis < Dim; ++axis) {
    const ElementView::Numbers& numbers = spheres.center(axis);
    columns.center[axis] = column_of<T>(numbers, spheres.precision());
  }
  if (spheres.has_common_radius()) {
    columns.common_radius = spheres.common_radius();
  } else {
    columns.radii = column_of<T>(spheres.radii(), spheres.precision());
  }
  columns.count = static_cast<std::uint32_t>(spheres.size());
  return columns;
}

/// Those of one set, or of two.
template <int Dim>
[[nodiscard]] JoinedColumns<Dim> joined_columns_of(const ElementView& first,
                                                   const ElementView* second) {
  JoinedColumns<Dim> joined{};
  joined.first = columns_of<Dim, EitherNumber>(first);
  joined.is_of_two_sets = second != nullptr;
  if (second != nullptr) joined.second = columns_of<Dim, EitherNumber>(*second);
  joined.count = joined.first.count + joined.second.count;
  return joined;
}

}  // namespace abut::device
