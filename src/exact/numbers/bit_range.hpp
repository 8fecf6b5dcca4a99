#pragma once

#include "base/host_device.hpp"
#include "exact/numbers/bits.hpp"

#include <algorithm>
#include <bit>

namespace abut::exact {

/// The bits that some finite numbers take together, as places of a binary fraction: how wide whole
/// numbers over a common power of two must be. Zeros take none.
class BitRange {
 public:
  ABUT_HD void include(double value) noexcept {
    const Decomposed d = decompose(value);
    if (d.significand == 0) return;
    lowest_ = std::min(lowest_, d.exponent + std::countr_zero(d.significand));
    highest_ = std::max(highest_, d.exponent + static_cast<int>(std::bit_width(d.significand)));
  }

  /// Exponent of the lowest bit that is set.
  [[nodiscard]] ABUT_HD int lowest() const noexcept { return lowest_; }
  /// Number of bits from the lowest to the highest; not positive if all numbers are zero.
  [[nodiscard]] ABUT_HD int bits() const noexcept { return highest_ - lowest_; }

 private:
  int lowest_ = 4096;
  int highest_ = -4096;
};

}  // namespace abut::exact
