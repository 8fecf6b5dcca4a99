#pragma once

#include <abut/image_shift.hpp>

namespace abut::base {

/// The shift of a pair as it is seen from its other element.
[[nodiscard]] constexpr ImageShift opposite(const ImageShift& shift) noexcept {
  return {-shift.x, -shift.y, -shift.z};
}

}  // namespace abut::base
