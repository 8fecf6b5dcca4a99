#pragma once

#include "device/bodies/box_columns.hpp"
#include "device/bodies/joined_columns.hpp"
#include "device/bodies/sphere_columns.hpp"
#include "device/device_request.hpp"

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

/// The columns of a view of boxes.
template <int Dim>
[[nodiscard]] BoxColumns<Dim> box_columns_of(const ElementView& boxes) {
  BoxColumns<Dim> columns{};
  for (int axis = 0; axis < Dim; ++axis) {
    columns.lower[axis] = column_of<EitherNumber>(boxes.lower(axis), boxes.precision());
    columns.upper[axis] = column_of<EitherNumber>(boxes.upper(axis), boxes.precision());
  }
  columns.count = static_cast<std::uint32_t>(boxes.size());
  return columns;
}

/// One set, or two, the second of no elements where there is none.
template <class Columns>
[[nodiscard]] Joined<Columns> joined(const Columns& first, const Columns& second, bool are_two) {
  return {first, second, are_two, first.count + second.count};
}

/// The spheres of one set, or of two.
template <int Dim>
[[nodiscard]] JoinedColumns<Dim> joined_columns_of(const ElementView& first,
                                                   const ElementView* second) {
  using Columns = SphereColumns<Dim, EitherNumber>;
  return joined(columns_of<Dim, EitherNumber>(first),
                second == nullptr ? Columns{} : columns_of<Dim, EitherNumber>(*second),
                second != nullptr);
}

/// The boxes of one set, or of two.
template <int Dim>
[[nodiscard]] JoinedBoxes<Dim> joined_boxes_of(const ElementView& first,
                                               const ElementView* second) {
  return joined(box_columns_of<Dim>(first),
                second == nullptr ? BoxColumns<Dim>{} : box_columns_of<Dim>(*second),
                second != nullptr);
}

/// Returns call(elements) of the elements as the stages take them that serve a request: those of
/// Pipeline, or of PeriodicPipeline for boxes, two sets, and what is not plain. `second` may be
/// null.
template <int Dim, class Call>
auto call_with_elements(const ElementView& first, const ElementView* second,
                        const DeviceRequest& request, const Call& call) {
  if (first.shape() == Shape::box) return call(joined_boxes_of<Dim>(first, second));
  if (second != nullptr || !request.is_plain(Dim)) {
    return call(joined_columns_of<Dim>(first, second));
  }
  return first.precision() == Precision::float64 ? call(columns_of<Dim, double>(first))
                                                 : call(columns_of<Dim, float>(first));
}

}  // namespace abut::device
