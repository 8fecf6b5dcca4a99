#pragma once

#include "exact/sphere.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace abut::grid {

/// The box of the centers and the sizes of some elements; of none, an inverted box.
template <int Dim>
struct Bounds {
  std::array<double, Dim> lower = filled(std::numeric_limits<double>::infinity());
  std::array<double, Dim> upper = filled(-std::numeric_limits<double>::infinity());
  double smallest_radius = std::numeric_limits<double>::infinity();
  double largest_radius = 0.0;
  double second_largest_radius = 0.0;

  void include_center(const exact::Sphere<Dim>& sphere) noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      lower[axis] = std::min(lower[axis], sphere.center[axis]);
      upper[axis] = std::max(upper[axis], sphere.center[axis]);
    }
  }

  void include_radius(double radius) noexcept {
    smallest_radius = std::min(smallest_radius, radius);
    second_largest_radius = std::max(second_largest_radius, std::min(radius, largest_radius));
    largest_radius = std::max(largest_radius, radius);
  }

  /// Two boxes are within reach as far as the wider one is wide: with the largest counted twice,
  /// the two largest radii + margin are the largest reach of boxes too.
  void count_largest_twice() noexcept { second_largest_radius = largest_radius; }

  [[nodiscard]] std::array<double, Dim> middle() const noexcept {
    std::array<double, Dim> result{};
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      result[axis] = 0.5 * lower[axis] + 0.5 * upper[axis];
    }
    return result;
  }

  /// The farthest that a center is from the middle along an axis.
  [[nodiscard]] double largest_half_width() const noexcept {
    double half = 0.0;
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      half = std::max(half, 0.5 * upper[axis] - 0.5 * lower[axis]);
    }
    return half;
  }

  void include(const Bounds& others) noexcept {
    for (std::size_t axis = 0; axis < Dim; ++axis) {
      lower[axis] = std::min(lower[axis], others.lower[axis]);
      upper[axis] = std::max(upper[axis], others.upper[axis]);
    }
    second_largest_radius = std::max({second_largest_radius, others.second_largest_radius,
                                      std::min(largest_radius, others.largest_radius)});
    largest_radius = std::max(largest_radius, others.largest_radius);
    smallest_radius = std::min(smallest_radius, others.smallest_radius);
  }

 private:
  static constexpr std::array<double, Dim> filled(double value) noexcept {
    std::array<double, Dim> result{};
    result.fill(value);
    return result;
  }
};

}  // namespace abut::grid
