#pragma once

#include "exact/sphere.hpp"
#include "kernels/strided_spheres.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <ostream>
#include <span>
#include <vector>

namespace abut::testing {

/// Ways in which the numbers of spheres lie in memory.
enum class Layout {
  columns,       ///< each number in an array of its own
  points,        ///< centers one behind the other, radii elsewhere
  packed,        ///< centers and radii one behind the other
  wide_records,  ///< with other numbers between them
  backwards,     ///< columns, the last number first
  radius_first,  ///< packed, but for the place of the radius
  mixed,         ///< a column for the first axis, records for the others
};

inline constexpr std::array all_layouts{
    Layout::columns,   Layout::points,       Layout::packed, Layout::wide_records,
    Layout::backwards, Layout::radius_first, Layout::mixed};

inline std::ostream& operator<<(std::ostream& out, Layout layout) {
  return out << "layout " << static_cast<int>(layout);
}

/// Spheres in one of these ways. What lies between their numbers is no number.
template <int Dim>
class LaidOut {
 public:
  LaidOut(std::span<const exact::Sphere<Dim>> spheres, Layout layout) : size_(spheres.size()) {
    columns_.size = size_;
    for (int axis = 0; axis < Dim; ++axis) place(axis, layout);
    place(radii, layout);
    numbers_.assign(std::size_t{8} * (size_ + 1), std::numeric_limits<double>::quiet_NaN());
    for (int column = 0; column < 4; ++column)
      columns_.begin[column] = numbers_.data() + begin_[column];
    for (std::size_t k = 0; k < size_; ++k) {
      for (int axis = 0; axis < Dim; ++axis) number(axis, k) = spheres[k].center[axis];
      number(radii, k) = spheres[k].radius;
    }
  }

  LaidOut(const LaidOut&) = delete;
  LaidOut& operator=(const LaidOut&) = delete;
  ~LaidOut() = default;

  [[nodiscard]] const kernels::StridedSpheres& columns() const noexcept { return columns_; }

 private:
  static constexpr int radii = kernels::StridedSpheres::radii;

  void place(int column, Layout layout) {
    const bool is_radius = column == radii;
    const auto number = static_cast<std::size_t>(is_radius ? Dim : column);
    const std::size_t in_columns = number * size_;
    const auto put = [&](std::size_t begin, std::ptrdiff_t stride) {
      begin_[column] = begin;
      columns_.stride[column] = stride;
    };
    switch (layout) {
      case Layout::columns:
        return put(in_columns, 1);
      case Layout::points:
        return is_radius ? put(in_columns, 1) : put(number, Dim);
      case Layout::packed:
        return put(number, Dim + 1);
      case Layout::wide_records:
        return put(number, 7);
      case Layout::backwards:
        return put(in_columns + size_ - (size_ > 0 ? 1 : 0), -1);
      case Layout::radius_first:
        return put(is_radius ? 0 : number + 1, Dim + 1);
      case Layout::mixed:
        return number == 0 ? put(7 * size_, 1) : put(number, 5);
    }
  }

  double& number(int column, std::size_t k) {
    const auto place = static_cast<std::ptrdiff_t>(begin_[column]) +
                       static_cast<std::ptrdiff_t>(k) * columns_.stride[column];
    return numbers_[static_cast<std::size_t>(place)];
  }

  std::size_t size_;
  std::size_t begin_[4] = {};
  std::vector<double> numbers_;
  kernels::StridedSpheres columns_{};
};

}  // namespace abut::testing
