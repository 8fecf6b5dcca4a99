#pragma once

// The slow path of the contract (docs/contract.md): four exact evaluations, cheapest first.
//
// 1. Nothing rounded. On touching lattices with short coordinates (a = 1, r = 1/2) every operation
//    of the filter happens to be exact, and then so is its comparison. Proof of that costs a few
//    nanoseconds: error terms that are zero, factors of at most 26 bits.
// 2. DoubleDouble precision. Sums and products as pairs of doubles, about thirty digits: decides
//    all pairs that do not touch exactly but are closer to it than the filter can see, such as
//    those of a lattice whose radius is the smallest double that touches.
// 3. Scaled integers. When all numbers, written over a common power of two, fit into 61 bits, the
//    differences fit into 62, their squares into 124, and the sum of three into a 128-bit integer:
//    about ten nanoseconds. Touching lattices and most borderline pairs end here.
// 4. The long accumulator, right for every finite double, for the rest.
//
// After the first one, what is apart along one axis alone is left out: nearly all pairs whose
// squares leave the range of the filter.

#include "base/host_device.hpp"
#include "exact/exact_stages.hpp"
#include "exact/numbers/bit_range.hpp"
#include "exact/numbers/bits.hpp"
#include "exact/numbers/double_double.hpp"
#include "exact/numbers/exact_accumulator.hpp"
#include "exact/sphere_predicate.hpp"

#include <bit>
#include <cmath>
#include <optional>

namespace abut::exact {
namespace detail {

/// Follows a computation and remembers whether any step rounded.
class RoundingWitness {
 public:
  /// a + b. If |a| >= |b|, sum - a is exact, and is b exactly when the sum is a + b (T. J. Dekker,
  /// A floating-point technique for extending the available precision, Numer. Math. 18 (1971)
  /// 224-242). Which one is larger need not be known when both are taken away in turn. Overflow
  /// leaves an infinity, zeros of either sign leave +0.
  ABUT_HD double add(double a, double b) noexcept {
    const double sum = a + b;
    remainders_ |= bits((sum - a) - b) | bits((sum - b) - a);
    return sum;
  }

  /// The square of a number of at most 26 significant bits has at most 52; it is exact if it also
  /// stays in the normal range.
  ABUT_HD double square(double value) noexcept {
    remainders_ |= bits(value) & bits_that_squares_lose;
    // Magnitudes compare like their bits; 0, which squares exactly, wraps round to the largest.
    tiny_ |= (bits(value) << 1) - 1 < (bits(smallest_exact_root) << 1) - 1;
    return value * value;
  }

  [[nodiscard]] ABUT_HD bool nothing_rounded() const noexcept { return remainders_ == 0 && !tiny_; }

 private:
  ABUT_HD static std::uint64_t bits(double value) noexcept {
    return std::bit_cast<std::uint64_t>(value);
  }

  std::uint64_t remainders_ = 0;  ///< all bits 0: every remainder was +0
  bool tiny_ = false;
};

}  // namespace detail

template <int Dim>
ABUT_HD std::optional<bool> decide_if_nothing_rounded(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                      double margin) noexcept {
  detail::RoundingWitness witness;
  double reach = witness.add(a.radius, b.radius);
  if (margin != 0.0) reach = witness.add(reach, margin);
  const double reach_squared = witness.square(reach);
  if (!witness.nothing_rounded()) return std::nullopt;
  double distance_squared = witness.square(witness.add(a.center[0], -b.center[0]));
  for (int axis = 1; axis < Dim; ++axis) {
    const double difference = witness.add(a.center[axis], -b.center[axis]);
    distance_squared = witness.add(distance_squared, witness.square(difference));
  }
  if (!witness.nothing_rounded()) [[unlikely]]
    return std::nullopt;
  return distance_squared <= reach_squared;
}

// THE ERROR, in units of S^2, with |D^2 - S^2| < S^2 / 2 as the filter left it. Differences and
// sums of radii are exact pairs; the margin makes the reach err by 2^-104. Squares err by 2^-103 of
// themselves, all four together by less than 2^-101. The high parts are added exactly. The eight
// low parts are below 2^-51 each and their sum errs by less than 2^-98. Together below 2^-97. What
// underflows is below 2^-1000, far less, for S >= 2^-400.
template <int Dim>
ABUT_HD std::optional<bool> decide_in_double_double(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                    double margin) noexcept {
  DoubleDouble reach = two_sum(a.radius, b.radius);
  if (margin != 0.0) {
    const DoubleDouble sum = two_sum(reach.high, margin);
    reach = two_sum(sum.high, sum.low + reach.low);
  }
  if (!(reach.high >= smallest_double_double_reach && reach.high <= largest_double_double_reach)) {
    return std::nullopt;
  }
  const DoubleDouble reach_squared = square(reach);
  double high = -reach_squared.high;
  double low = -reach_squared.low;
  for (int axis = 0; axis < Dim; ++axis) {
    const DoubleDouble difference = two_sum(a.center[axis], -b.center[axis]);
    if (!(std::fabs(difference.high) <= 2.0 * reach.high)) return std::nullopt;
    const DoubleDouble term = square(difference);
    const DoubleDouble sum = two_sum(high, term.high);
    high = sum.high;
    low += sum.low + term.low;
  }
  const double excess = high + low;
  if (!(std::fabs(excess) > double_double_band * reach_squared.high)) return std::nullopt;
  return excess < 0.0;
}

namespace detail {

/// All numbers of one decision as integers times one power of two.
class CommonScale {
 public:
  ABUT_HD void include(double value) noexcept { range_.include(value); }

  [[nodiscard]] ABUT_HD bool fits() const noexcept { return range_.bits() <= 61; }

  /// Exact: below 2^61 in magnitude.
  [[nodiscard]] ABUT_HD std::int64_t scaled(double value) const noexcept {
    const Decomposed d = decompose(value);
    if (d.significand == 0) return 0;
    const int shift = d.exponent - range_.lowest();
    const std::uint64_t magnitude = shift >= 0 ? d.significand << shift : d.significand >> -shift;
    const auto integer = static_cast<std::int64_t>(magnitude);
    return d.negative ? -integer : integer;
  }

 private:
  BitRange range_;
};

ABUT_HD inline Uint128 square_of_integer(std::int64_t value) noexcept {
  const auto magnitude = static_cast<std::uint64_t>(value < 0 ? -value : value);
  return Uint128{magnitude} * magnitude;
}

}  // namespace detail

template <int Dim>
ABUT_HD std::optional<bool> decide_scaled(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                          double margin) noexcept {
  detail::CommonScale scale;
  for (int axis = 0; axis < Dim; ++axis) {
    scale.include(a.center[axis]);
    scale.include(b.center[axis]);
  }
  scale.include(a.radius);
  scale.include(b.radius);
  scale.include(margin);
  if (!scale.fits()) return std::nullopt;

  Uint128 distance_squared = 0;  // <= 3 * 2^124
  for (int axis = 0; axis < Dim; ++axis) {
    distance_squared +=
        detail::square_of_integer(scale.scaled(a.center[axis]) - scale.scaled(b.center[axis]));
  }
  // <= 3 * 2^61, whose square is below 2^126
  const std::int64_t reach = scale.scaled(a.radius) + scale.scaled(b.radius) + scale.scaled(margin);
  return distance_squared <= detail::square_of_integer(reach);
}

/// Sign of (r_a + r_b + m)^2 - |a - b|^2, expanded into products of inputs.
template <int Dim>
ABUT_HD bool decide_accumulated(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                double margin) noexcept {
  ExactAccumulator slack;
  for (int axis = 0; axis < Dim; ++axis) {
    const double p = a.center[axis];
    const double q = b.center[axis];
    slack.add_product(p, p, -1);
    slack.add_product(p, q, 2);
    slack.add_product(q, q, -1);
  }
  slack.add_product(a.radius, a.radius, 1);
  slack.add_product(b.radius, b.radius, 1);
  slack.add_product(a.radius, b.radius, 2);
  slack.add_product(margin, margin, 1);
  slack.add_product(margin, a.radius, 2);
  slack.add_product(margin, b.radius, 2);
  return slack.sign() >= 0;
}

namespace detail {

/// Tells whether two spheres are farther apart along an axis than they reach, by more than all
/// roundings.
///
/// THE ERROR. With u = 2^-53, differences err by u of themselves, sums of three numbers that are
/// not negative by 2 u, and the product by u, which leaves more than 4 u of the 16 u in between.
/// Sums and differences below 2^-1022 are exact, and the product is never rounded to less than the
/// reach. A difference beyond the largest double is larger than any finite reach; where the reach
/// is infinite, nothing is decided.
template <int Dim>
ABUT_HD bool are_apart_on_an_axis(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                  double margin) noexcept {
  if (!(margin >= 0.0)) return false;
  const double farthest = (a.radius + b.radius + margin) * (1.0 + band);
  bool are_apart = false;
  for (int axis = 0; axis < Dim; ++axis) {
    are_apart = are_apart || std::fabs(a.center[axis] - b.center[axis]) > farthest;
  }
  return are_apart;
}

/// Out of line, so that the first stage needs no stack of its own.
template <int Dim>
[[gnu::noinline]] ABUT_HD bool decide_in_long_integers(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                                       double margin) noexcept {
  if (are_apart_on_an_axis(a, b, margin)) return false;
  if (const std::optional<bool> decided = decide_in_double_double(a, b, margin)) return *decided;
  if (const std::optional<bool> decided = decide_scaled(a, b, margin)) return *decided;
  return decide_accumulated(a, b, margin);
}

}  // namespace detail

template <int Dim>
ABUT_HD bool within_reach_exactly(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                  double margin) noexcept {
  if (const std::optional<bool> decided = decide_if_nothing_rounded(a, b, margin)) return *decided;
  return detail::decide_in_long_integers(a, b, margin);
}

}  // namespace abut::exact
