#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <string_view>

namespace abut::base {

/// Counts the bytes that one detection holds in its own buffers, and refuses what passes the bound
/// before it is allocated. Workers may take and give back at the same time.
class MemoryMeter {
 public:
  static constexpr std::uint64_t unbounded = std::numeric_limits<std::uint64_t>::max();

  MemoryMeter() = default;
  explicit MemoryMeter(std::uint64_t bound) : bound_(bound) {}

  MemoryMeter(const MemoryMeter&) = delete;
  MemoryMeter& operator=(const MemoryMeter&) = delete;
  ~MemoryMeter() = default;

  /// A new bound and peaks that start from what is held, for a meter that outlives a detection.
  void start_anew(std::uint64_t bound) noexcept;

  /// Throws Error{limit_exceeded} when `bytes` more would pass the bound. `what` completes
  /// "... bytes are needed for ..."; `advice` says what to do instead.
  void require(std::uint64_t bytes, std::string_view what, std::string_view advice) const;

  void take(std::uint64_t bytes);
  void give_back(std::uint64_t bytes) noexcept {
    working_ -= bytes;
    held_ -= bytes;
  }

  /// Counts bytes of the list of pairs that is the result, which is not a working array.
  void take_for_pairs(std::uint64_t bytes);
  void give_back_pairs(std::uint64_t bytes) noexcept { held_ -= bytes; }

  [[nodiscard]] std::uint64_t held() const noexcept { return held_; }
  /// Bytes that are held without the pairs.
  [[nodiscard]] std::uint64_t working() const noexcept { return working_; }
  [[nodiscard]] std::uint64_t peak() const noexcept { return peak_; }
  [[nodiscard]] std::uint64_t working_peak() const noexcept { return working_peak_; }
  [[nodiscard]] std::uint64_t bound() const noexcept { return bound_; }

 private:
  void hold(std::uint64_t bytes, std::string_view what, std::string_view advice);

  std::uint64_t bound_ = unbounded;
  std::atomic<std::uint64_t> held_ = 0;
  std::atomic<std::uint64_t> peak_ = 0;
  std::atomic<std::uint64_t> working_ = 0;  ///< of what is held: without the pairs
  std::atomic<std::uint64_t> working_peak_ = 0;
};

}  // namespace abut::base
