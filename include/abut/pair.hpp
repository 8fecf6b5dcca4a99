#pragma once

#include <abut/export.hpp>

#include <compare>
#include <cstdint>

namespace abut {

/// Number of an element: its position in the caller's arrays, from 0.
using ElementIndex = std::uint32_t;

/// Counts and offsets of pairs are always 64 bits wide.
using PairCount = std::uint64_t;

/// Two elements that touch or lie within reach of each other; first < second. In a periodic domain
/// also an element and an image of itself: first = second.
struct ContactPair {
  ElementIndex first = 0;
  ElementIndex second = 0;

  friend constexpr auto operator<=>(const ContactPair&, const ContactPair&) = default;
};

}  // namespace abut
