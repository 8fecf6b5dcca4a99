#pragma once

#include <cstdint>

namespace abut::device {

/// The most bytes that a detection holds in the memory of a device, the caller's arrays and the
/// scratch of the executor left aside.
struct MemoryPlan {
  std::uint64_t search_bytes;  ///< while partners are counted, and beside the pairs when written
  std::uint64_t pair_bytes;    ///< of the list while it is brought into order
  std::uint64_t gap_bytes;     ///< more, where a domain is so wide that gaps are closed

  /// Of a detection in a domain without wide gaps; in any domain `gap_bytes` more.
  [[nodiscard]] std::uint64_t bytes() const noexcept { return search_bytes + pair_bytes; }
};

/// What `elements` and a list of `pairs` take: contact pairs and those in doubt together.
[[nodiscard]] MemoryPlan plan_memory(std::uint64_t elements, std::uint64_t pairs) noexcept;

}  // namespace abut::device
