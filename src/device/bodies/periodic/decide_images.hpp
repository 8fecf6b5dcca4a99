#pragma once

#include "base/host_device.hpp"
#include "device/bodies/decide.hpp"
#include "device/bodies/periodic/periodic_elements.hpp"
#include "exact/far_image-inl.hpp"
#include "exact/periodic_box-inl.hpp"
#include "exact/periodic_predicate-inl.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace abut::device {

/// All stages of the predicate with a lattice. Nothing for a pair within reach whose shift exceeds
/// 2^31 - 1: it must be refused, also where its elements may not pair.
template <class Given, class Ghosts>
[[nodiscard]] ABUT_HD std::optional<bool> decide_at_last(
    const PeriodicElements<Given, Ghosts>& elements, const ContactPair& pair,
    double margin) noexcept {
  const auto a = elements.given().whole(pair.first);
  const auto b = elements.given().whole(elements.element_of(pair.second));
  constexpr exact::Int128 largest = 2147483647;
  const exact::FarShift far = elements.far_shift_of(pair);
  bool fits = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fits = fits && far[axis] <= largest && far[axis] >= -largest;
  }
  if (fits) {
    if (!elements.may_pair(pair)) return false;
    const exact::LatticeSteps<Given::dimensions> steps(elements.shift_of(pair), elements.map.given);
    return exact::within_reach_exactly(a, b, steps, margin);
  }
  if (exact::far_image_within_reach(a, b, far, elements.map.given, margin)) return std::nullopt;
  return false;
}

}  // namespace abut::device
