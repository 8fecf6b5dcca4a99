#pragma once

#include "base/host_device.hpp"
#include "base/opposite_shift.hpp"
#include "device/bodies/apart_pair.hpp"
#include "device/bodies/periodic/periodic_elements.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// Whether the first component of a shift that is not 0 is positive.
[[nodiscard]] ABUT_HD inline bool is_positive(const ImageShift& shift) noexcept {
  if (shift.x != 0) return shift.x > 0;
  if (shift.y != 0) return shift.y > 0;
  return shift.z > 0;
}

/// Body: turns pair k of locals and ghosts into one of elements, each numbered in its set, and
/// tells its shift. What is apart stays so.
template <class Spheres>
struct NamePair {
  Spheres elements;
  ContactPair* pairs;
  ImageShift* shifts;  ///< null where nobody asks for them

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ContactPair pair = pairs[k];
    if (is_apart(pair)) {
      if (shifts != nullptr) shifts[k] = {};
      return;
    }
    const std::uint32_t first = pair.first;
    const std::uint32_t second = elements.element_of(pair.second);
    const ContactPair named = elements.given().named(first, second);
    const bool turned = named.first != first;
    pairs[k] = named;
    if (shifts == nullptr) return;
    const ImageShift shift = elements.shift_of(pair);
    const bool is_own = first == second && !is_positive(shift);
    shifts[k] = turned || is_own ? base::opposite(shift) : shift;
  }
};

}  // namespace abut::device
