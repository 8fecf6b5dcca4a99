#pragma once

#include "exact/sphere.hpp"
#include "kernels/follow_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace abut::skin {

/// Of the displacement of an element from its anchor.
template <int Dim>
[[nodiscard]] double squared_displacement(const exact::Sphere<Dim>& now,
                                          const exact::Sphere<Dim>& anchor) noexcept {
  double sum = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double difference = now.center[axis] - anchor.center[axis];
    sum += difference * difference;
  }
  return sum;
}

/// The two longest of the ways that elements have gone since they were anchored, the growth of
/// their radii included: no two elements have come closer by more than their sum.
class LongestWays {
 public:
  /// A way whose displacement has this square. Of most the square tells that they change nothing,
  /// without a root.
  void include_square(double square, double growth) noexcept {
    if (square < negligible_ && growth == 0.0) return;
    include(std::sqrt(square), growth);
    negligible_ = kernels::negligible_square(longest_.second);
  }

  void include(const LongestWays& others) noexcept {
    longest_.second = std::max(
        {longest_.second, others.longest_.second, std::min(longest_.first, others.longest_.first)});
    longest_.first = std::max(longest_.first, others.longest_.first);
    known_ = known_ && others.known_;
  }

  /// Has `kernel(kernels::LongestTwo&)` include some ways; returns what it does.
  template <class Kernel>
  auto widen(Kernel&& kernel) {
    const auto result = kernel(longest_);
    negligible_ = kernels::negligible_square(longest_.second);
    return result;
  }

  /// An element of which nothing is known.
  void include_unknown() noexcept { known_ = false; }

  /// False if one of the ways was no finite number, or unknown.
  [[nodiscard]] bool known() const noexcept { return known_; }
  [[nodiscard]] double longest() const noexcept { return longest_.first; }

  /// Upper bound of the sum of any two ways, but for the rounding of the sum; infinite if unknown.
  [[nodiscard]] double sum_of_two() const noexcept {
    return known_ ? longest_.first + longest_.second + underflow : infinite;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// Upper bound of what a displacement loses if squares of its components underflow.
  static constexpr double underflow = 0x1p-500;

  void include(double displacement, double growth) noexcept {
    const double sum = displacement + growth;
    const double way = sum + kernels::displacement_band * (displacement + std::fabs(growth));
    known_ = known_ && way < infinite;  // NaN is not
    longest_.second = std::max(longest_.second, std::min(way, longest_.first));
    longest_.first = std::max(longest_.first, way);
  }

  kernels::LongestTwo longest_;
  double negligible_ = 0.0;  ///< squares below are of ways shorter than the second
  bool known_ = true;
};

}  // namespace abut::skin
