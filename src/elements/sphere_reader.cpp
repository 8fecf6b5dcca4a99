#include "elements/sphere_reader.hpp"

#include "elements/number_reader.hpp"

#include <abut/column.hpp>

#include <algorithm>
#include <cstdint>

namespace abut::elements {
namespace {

constexpr int radius_column = 3;

/// Returns where contiguous doubles lie, or null.
const double* contiguous_doubles(const ElementView& spheres, const ElementView::Numbers& numbers) {
  const bool is_contiguous = spheres.precision() == Precision::float64 &&
                             numbers.stride_bytes == sizeof(double) &&
                             reinterpret_cast<std::uintptr_t>(numbers.first) % alignof(double) == 0;
  return is_contiguous ? reinterpret_cast<const double*>(numbers.first) : nullptr;
}

const ElementView::Numbers& numbers_of(const ElementView& spheres, int number) {
  return number == radius_column ? spheres.radii() : spheres.center(number);
}

template <Real T>
void copy(const ElementView::Numbers& numbers, std::size_t first, std::span<double> target) {
  const NumberReader<T> reader(numbers);
  for (std::size_t k = 0; k < target.size(); ++k) target[k] = reader[first + k];
}

}  // namespace

SphereReader::SphereReader(const ElementView& spheres) : spheres_(spheres), in_place_{} {
  for (int axis = 0; axis < spheres.dimensions(); ++axis) {
    in_place_[axis] = contiguous_doubles(spheres, spheres.center(axis));
  }
  if (!spheres.has_common_radius()) {
    in_place_[radius_column] = contiguous_doubles(spheres, spheres.radii());
  }
}

kernels::ElementColumns SphereReader::read(std::size_t first, std::size_t count,
                                           std::span<double> room) const {
  kernels::ElementColumns columns{};
  for (int axis = 0; axis < spheres_.dimensions(); ++axis) {
    columns.center[axis] =
        column(axis, first, room.subspan(static_cast<std::size_t>(axis) * count, count));
  }
  columns.radius = column(radius_column, first, room.subspan(3 * count, count));
  return columns;
}

const double* SphereReader::column(int number, std::size_t first, std::span<double> room) const {
  if (in_place_[number] != nullptr) return in_place_[number] + first;
  if (number == radius_column && spheres_.has_common_radius()) {
    std::fill(room.begin(), room.end(), spheres_.common_radius());
  } else if (spheres_.precision() == Precision::float32) {
    copy<float>(numbers_of(spheres_, number), first, room);
  } else {
    copy<double>(numbers_of(spheres_, number), first, room);
  }
  return room.data();
}

}  // namespace abut::elements
