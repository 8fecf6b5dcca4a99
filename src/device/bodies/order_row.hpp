#pragma once

#include "base/host_device.hpp"
#include "device/bodies/apart_pair.hpp"

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

/// What the host must know of pairs in order: how many are contacts, and the most that stand
/// together; one more than the longest short row stands for all that are more.
struct OrderSummary {
  std::uint64_t contacts = 0;
  std::uint64_t longest = 0;  ///< as wide as the others: no byte is copied that nobody wrote
};

struct JoinOrderSummaries {
  [[nodiscard]] ABUT_HD OrderSummary operator()(const OrderSummary& a,
                                                const OrderSummary& b) const noexcept {
    return {a.contacts + b.contacts, a.longest < b.longest ? b.longest : a.longest};
  }
};

/// Body of a reduction: pair k, sorted by first numbers, and the length of the row that begins with
/// it, 0 where none does.
struct SummaryOfRow {
  const ContactPair* pairs;
  std::uint64_t count;

  [[nodiscard]] ABUT_HD OrderSummary operator()(std::uint64_t k) const noexcept {
    if (is_apart(pairs[k])) return {};
    return {1, begins_row(pairs, k) ? length_from(k) : 0};
  }

 private:
  [[nodiscard]] ABUT_HD std::uint64_t length_from(std::uint64_t k) const noexcept {
    std::uint64_t length = 1;
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
