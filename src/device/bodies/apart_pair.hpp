#pragma once

#include "base/host_device.hpp"

#include <abut/pair.hpp>

#include <cstdint>
#include <limits>

namespace abut::device {

/// What a pair in doubt becomes that is apart. It is behind all pairs when these are in order, by
/// as many bits as the number of elements has: no element has the number of all ones.
[[nodiscard]] ABUT_HD constexpr ContactPair apart_pair() noexcept {
  return {std::numeric_limits<std::uint32_t>::max(), std::numeric_limits<std::uint32_t>::max()};
}

[[nodiscard]] ABUT_HD inline bool is_apart(const ContactPair& pair) noexcept {
  return pair.first == apart_pair().first;
}

/// Whether a decided pair is a contact pair.
struct ContactTester {
  [[nodiscard]] ABUT_HD bool operator()(const ContactPair& pair) const noexcept {
    return !is_apart(pair);
  }
};

}  // namespace abut::device
