#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace abut::base {

/// Counts the bytes that one detection holds in its own buffers, and refuses what passes the bound
/// before it is allocated.
class MemoryMeter {
 public:
  static constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

  MemoryMeter() = default;
  explicit MemoryMeter(std::uint64_t bound) : bound_(bound) {}

  MemoryMeter(const MemoryMeter&) = delete;
  MemoryMeter& operator=(const MemoryMeter&) = delete;

  /// Throws Error{limit_exceeded} when `bytes` more would pass the bound. `what` completes
  /// "... bytes are needed for ..."; `advice` says what to do instead.
  void require(std::uint64_t bytes, std::string_view what, std::string_view advice) const;

  void take(std::uint64_t bytes);
  void give_back(std::uint64_t bytes) noexcept { held_ -= bytes; }

  [[nodiscard]] std::uint64_t held() const noexcept { return held_; }
  [[nodiscard]] std::uint64_t peak() const noexcept { return peak_; }
  [[nodiscard]] std::uint64_t bound() const noexcept { return bound_; }

 private:
  std::uint64_t bound_ = unbounded;
  std::uint64_t held_ = 0;
  std::uint64_t peak_ = 0;
};

}  // namespace abut::base
