#pragma once

#include "base/host_device.hpp"
#include "exact/numbers/double_double.hpp"

#include <array>
#include <cstddef>

namespace abut::exact {

/// A sum of at most Most doubles, exactly: as doubles that do not overlap, by ascending magnitude
/// (J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates, Discrete Comput. Geom. 18 (1997) 305-363, theorem 10). Where nothing overflows.
template <std::size_t Most>
class ExactSum {
 public:
  ABUT_HD void add(double term) noexcept {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count_; ++k) {
      const DoubleDouble sum = two_sum(term, parts_[k]);
      term = sum.high;
      if (sum.low != 0.0) parts_[kept++] = sum.low;
    }
    if (term != 0.0) parts_[kept++] = term;
    count_ = kept;
  }
  ABUT_HD void add(const DoubleDouble& term) noexcept {
    add(term.high);
    add(term.low);
  }

  /// Returns the sum rounded to the nearest double, to even between two; never -0.0.
  [[nodiscard]] ABUT_HD double rounded() const noexcept {
    if (count_ == 0) return 0.0;
    std::size_t k = count_ - 1;
    DoubleDouble sum{parts_[k], 0.0};
    while (k > 0 && sum.low == 0.0) sum = two_sum(sum.high, parts_[--k]);
    if (k == 0 || (sum.low < 0.0) != (parts_[k - 1] < 0.0)) return sum.high;
    // What is still below may tip the balance where `low` is half of the last place of `high`.
    const double twice = 2.0 * sum.low;
    const double next = sum.high + twice;
    return next - sum.high == twice ? next : sum.high;
  }

 private:
  std::array<double, Most> parts_{};
  std::size_t count_ = 0;
};

}  // namespace abut::exact
