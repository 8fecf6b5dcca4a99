#include "elements/strided_elements.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::elements {
namespace {

constexpr auto bytes = static_cast<std::ptrdiff_t>(sizeof(double));

bool can_be_read(const ElementView::Numbers& numbers) {
  return reinterpret_cast<std::uintptr_t>(numbers.first) % alignof(double) == 0 &&
         numbers.stride_bytes % bytes == 0;
}

/// Points a column at these numbers; returns whether they can be read there.
template <class Columns>
bool put_numbers(Columns& columns, int column, const ElementView::Numbers& numbers) {
  columns.begin[column] = reinterpret_cast<const double*>(numbers.first);
  columns.stride[column] = numbers.stride_bytes / bytes;
  return can_be_read(numbers);
}

}  // namespace

std::optional<kernels::StridedSpheres> strided_spheres(const ElementView& spheres,
                                                       const double* common_radius) {
  if (spheres.shape() != Shape::sphere || spheres.precision() != Precision::float64) {
    return std::nullopt;
  }
  kernels::StridedSpheres columns{};
  columns.size = spheres.size();
  const auto put = [&](int column, const ElementView::Numbers& numbers) {
    return put_numbers(columns, column, numbers);
  };
  for (int axis = 0; axis < spheres.dimensions(); ++axis) {
    if (!put(axis, spheres.center(axis))) return std::nullopt;
  }
  if (spheres.has_common_radius()) {
    columns.begin[kernels::StridedSpheres::radii] = common_radius;
  } else if (!put(kernels::StridedSpheres::radii, spheres.radii())) {
    return std::nullopt;
  }
  return columns;
}

std::optional<kernels::StridedBoxes> strided_boxes(const ElementView& boxes) {
  if (boxes.shape() != Shape::box || boxes.precision() != Precision::float64) return std::nullopt;
  kernels::StridedBoxes columns{};
  columns.size = boxes.size();
  const auto put = [&](int column, const ElementView::Numbers& numbers) {
    return put_numbers(columns, column, numbers);
  };
  for (int axis = 0; axis < boxes.dimensions(); ++axis) {
    const int upper = kernels::StridedBoxes::upper_corners + axis;
    if (!put(axis, boxes.lower(axis)) || !put(upper, boxes.upper(axis))) return std::nullopt;
  }
  return columns;
}

}  // namespace abut::elements
