#pragma once

#include "base/host_device.hpp"
#include "exact/far_image.hpp"
#include "exact/numbers/exact_accumulator.hpp"

#include <cstddef>
#include <cstdint>

namespace abut::exact {
namespace detail {

inline constexpr int digit_bits = 31;
inline constexpr std::size_t digits_of_shift = 4;

/// A sum of doubles, each times a factor and a power of two. It is never formed: long accumulators
/// hold it, or its square.
class FarTerms {
 public:
  struct FarTerm {
    double value;
    std::int64_t factor;
    int power;
  };

  ABUT_HD void add(double value, std::int64_t factor, int power = 0) noexcept {
    terms_[count_++] = {value, factor, power};
  }

  /// Adds what a shift moves by on an axis, or takes it away: sign is 1 or -1. Digits of 31 bits,
  /// so that two of them make a factor of 62.
  ABUT_HD void add_moved(const FarShift& shift, const Lattice& lattice, std::size_t axis,
                         std::int64_t sign) noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!lattice.periodic[k]) continue;
      const bool negative = shift[k] < 0;
      auto rest = negative ? -static_cast<Uint128>(shift[k]) : static_cast<Uint128>(shift[k]);
      for (int power = 0; rest != 0; power += digit_bits, rest >>= digit_bits) {
        const auto digit = static_cast<std::int64_t>(rest & ((Uint128{1} << digit_bits) - 1));
        add(lattice.vectors[k][axis], negative ? -sign * digit : sign * digit, power);
      }
    }
  }

  [[nodiscard]] ABUT_HD const FarTerm* begin() const noexcept { return terms_.data(); }
  [[nodiscard]] ABUT_HD const FarTerm* end() const noexcept { return terms_.data() + count_; }

 private:
  std::array<FarTerm, 3 + 3 * digits_of_shift> terms_{};
  std::size_t count_ = 0;
};

[[nodiscard]] ABUT_HD inline bool is_positive(const FarTerms& terms) noexcept {
  ExactAccumulator<1> sum;
  for (const auto& [value, factor, power] : terms) sum.add(value, factor, power);
  return sum.sign() > 0;
}

}  // namespace detail

template <int Dim>
ABUT_HD bool far_image_within_reach(const Sphere<Dim>& a, const Sphere<Dim>& b,
                                    const FarShift& shift, const Lattice& lattice,
                                    double margin) noexcept {
  ExactAccumulator<2> slack;
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    detail::FarTerms difference;
    difference.add(a.center[axis], 1);
    difference.add(b.center[axis], -1);
    difference.add_moved(shift, lattice, axis, -1);
    for (const auto& p : difference) {
      for (const auto& q : difference) {
        slack.add_product(p.value, q.value, -p.factor * q.factor, p.power + q.power);
      }
    }
  }
  const std::array<double, 3> reach{a.radius, b.radius, margin};
  for (const double p : reach) {
    for (const double q : reach) slack.add_product(p, q, 1);
  }
  return slack.sign() >= 0;
}

template <int Dim>
ABUT_HD bool far_image_within_reach(const Box<Dim>& a, const Box<Dim>& b, const FarShift& shift,
                                    const Lattice& lattice, double margin) noexcept {
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    detail::FarTerms a_behind_b;
    a_behind_b.add(a.lower[axis], 1);
    a_behind_b.add(b.upper[axis], -1);
    a_behind_b.add(margin, -1);
    a_behind_b.add_moved(shift, lattice, axis, -1);
    detail::FarTerms b_behind_a;
    b_behind_a.add(b.lower[axis], 1);
    b_behind_a.add(a.upper[axis], -1);
    b_behind_a.add(margin, -1);
    b_behind_a.add_moved(shift, lattice, axis, 1);
    if (detail::is_positive(a_behind_b) || detail::is_positive(b_behind_a)) return false;
  }
  return true;
}

}  // namespace abut::exact
