#pragma once

#include "base/host_device.hpp"

namespace abut::device {

/// The larger of two numbers.
struct Larger {
  template <class Number>
  [[nodiscard]] ABUT_HD Number operator()(Number a, Number b) const noexcept {
    return a < b ? b : a;
  }
};

/// The smaller of two numbers.
struct Smaller {
  template <class Number>
  [[nodiscard]] ABUT_HD Number operator()(Number a, Number b) const noexcept {
    return b < a ? b : a;
  }
};

}  // namespace abut::device
