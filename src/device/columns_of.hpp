#pragma once

#include "device/bodies/sphere_columns.hpp"

#include <abut/element_view.hpp>

#include <cstdint>

namespace abut::device {

/// The columns of a view of spheres of Dim dimensions and numbers of type T.
template <int Dim, class T>
[[nodiscard]] SphereColumns<Dim, T> columns_of(const ElementView& spheres) {
  using Column = typename SphereColumns<Dim, T>::Column;
  SphereColumns<Dim, T> columns{};
  for (int axis = 0; axis < Dim; ++axis) {
    const ElementView::Numbers& numbers = spheres.center(axis);
    columns.center[axis] = Column{numbers.first, numbers.stride_bytes};
  }
  if (spheres.has_common_radius()) {
    columns.common_radius = spheres.common_radius();
  } else {
    columns.radii = Column{spheres.radii().first, spheres.radii().stride_bytes};
  }
  columns.count = static_cast<std::uint32_t>(spheres.size());
  return columns;
}

}  // namespace abut::device
