#pragma once

#include <abut/export.hpp>

#include <compare>
#include <cstdint>

namespace abut {

/// Index of an element: its position in the caller's arrays, from 0.
using ElementIndex = std::uint32_t;

/// Count or offset of pairs, always 64 bits wide.
using PairCount = std::uint64_t;

/// Two elements that touch or lie within reach of each other; first < second. In a periodic domain
/// also an element and an image of itself: first = second.
struct ContactPair {
  ElementIndex first = 0;   ///< index of the one element
  ElementIndex second = 0;  ///< index of the other element

  /// Compares the first indices, then the second ones.
  friend constexpr auto operator<=>(const ContactPair&, const ContactPair&) = default;
};

}  // namespace abut
