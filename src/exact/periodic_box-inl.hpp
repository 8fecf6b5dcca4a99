#pragma once

// Decisions about boxes with a lattice between them which doubles cannot make
// (docs/derivations/periodic_predicate.md), for both processors.

#include "base/host_device.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/periodic_box.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace abut::exact {
namespace detail {

/// The box of a pair that is moved.
enum class Moved { first, second };

/// The distance by which, on one axis, the first box begins behind the end of the second: lower -
/// upper, and n A for the box that is moved by it.
template <int Dim>
class Excess {
 public:
  ABUT_HD Excess(double lower, double upper, const LatticeSteps<Dim>& steps, int axis,
                 Moved moved) noexcept
      : lower_(lower),
        upper_(upper),
        steps_(steps),
        axis_(axis),
        sign_(moved == Moved::first ? 1 : -1) {}

  /// True if the excess is at most `margin` in real arithmetic.
  [[nodiscard]] ABUT_HD bool at_most(double margin) const noexcept {
    const CompensatedSum sum = in_doubles(margin);
    return sum.rounded() ? accumulated(margin).sign() <= 0 : sum.value().high <= 0.0;
  }

  /// Returns the excess to the nearest double, ties to even.
  [[nodiscard]] ABUT_HD double rounded() const noexcept {
    const CompensatedSum sum = in_doubles(0.0);
    return sum.rounded() ? accumulated(0.0).rounded() : sum.value().high;
  }

 private:
  /// Returns the excess less the margin as a compensated sum. Products of an integer and a double
  /// lose nothing by underflow: all are multiples of the last bit of the double. An overflow leaves
  /// an infinity or a NaN among the rounding errors.
  [[nodiscard]] ABUT_HD CompensatedSum in_doubles(double margin) const noexcept {
    CompensatedSum sum;
    sum.add(lower_);
    sum.add(-upper_);
    for (const auto& step : steps_) {
      sum.add(two_product(sign_ * static_cast<double>(step.number), step.vector[axis_]));
    }
    sum.add(-margin);
    return sum;
  }

  [[nodiscard]] ABUT_HD ExactAccumulator<1> accumulated(double margin) const noexcept {
    ExactAccumulator<1> sum;
    sum.add(lower_, 1);
    sum.add(upper_, -1);
    for (const auto& step : steps_) {
      sum.add(step.vector[axis_], std::int64_t{sign_} * step.number);
    }
    sum.add(margin, -1);
    return sum;
  }

  double lower_;
  double upper_;
  const LatticeSteps<Dim>& steps_;
  int axis_;
  int sign_;
};

/// Returns both excesses on one axis: of a behind the image of b, and of that image behind a.
template <int Dim>
[[nodiscard]] ABUT_HD std::array<Excess<Dim>, 2> excesses(const Box<Dim>& a, const Box<Dim>& b,
                                                          const LatticeSteps<Dim>& steps,
                                                          int axis) noexcept {
  return {Excess<Dim>(a.lower[axis], b.upper[axis], steps, axis, Moved::second),
          Excess<Dim>(b.lower[axis], a.upper[axis], steps, axis, Moved::first)};
}

}  // namespace detail

template <int Dim>
ABUT_HD bool within_reach_exactly(const Box<Dim>& a, const Box<Dim>& b,
                                  const LatticeSteps<Dim>& steps, double margin) noexcept {
  for (int axis = 0; axis < Dim; ++axis) {
    for (const detail::Excess<Dim>& excess : detail::excesses(a, b, steps, axis)) {
      if (!excess.at_most(margin)) return false;
    }
  }
  return true;
}

template <int Dim>
ABUT_HD double gap(const Box<Dim>& a, const Box<Dim>& b, const ImageShift& shift,
                   const Lattice& lattice) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  const LatticeSteps<Dim> steps(shift, lattice);
  double result = -largest;
  for (int axis = 0; axis < Dim; ++axis) {
    for (const detail::Excess<Dim>& excess : detail::excesses(a, b, steps, axis)) {
      result = std::max(result, excess.rounded());
    }
  }
  // Adding 0 makes -0 a 0: max may return either of two zeros.
  return std::min(result, largest) + 0.0;
}

}  // namespace abut::exact
