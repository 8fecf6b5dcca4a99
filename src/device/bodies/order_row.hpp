#pragma once

#include "base/host_device.hpp"

#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// Rows up to this length are sorted one by one.
inline constexpr std::uint32_t longest_short_row = 64;

// A row is the pairs of one first element. Bodies look at the first numbers of other rows and move
// second numbers of their own row, so that no two items touch one place.

[[nodiscard]] ABUT_HD inline bool begins_row(const ContactPair* pairs, std::uint64_t k) noexcept {
  return k == 0 || pairs[k - 1].first != pairs[k].first;
}

/// Body: the length of the row that begins at pair k, 0 where none does; one more than the longest
/// short one stands for all that are longer.
struct RowLength {
  const ContactPair* pairs;
  std::uint64_t count;

  [[nodiscard]] ABUT_HD std::uint32_t operator()(std::uint64_t k) const noexcept {
    if (!begins_row(pairs, k)) return 0;
    std::uint32_t length = 1;
    while (length <= longest_short_row && k + length < count &&
           pairs[k + length].first == pairs[k].first) {
      ++length;
    }
    return length;
  }
};

/// Body: sorts the row that begins at pair k by insertion.
struct OrderRow {
  ContactPair* pairs;
  std::uint64_t count;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (!begins_row(pairs, k)) return;
    for (std::uint64_t next = k + 1; next < count && pairs[next].first == pairs[k].first; ++next) {
      const std::uint32_t second = pairs[next].second;
      std::uint64_t place = next;
      for (; place > k && pairs[place - 1].second > second; --place) {
        pairs[place].second = pairs[place - 1].second;
      }
      pairs[place].second = second;
    }
  }
};

}  // namespace abut::device
