#pragma once

#include "device/bodies/partners.hpp"
#include "device/executor.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace abut::device {

/// The sums of parts of searches, one after the other. The device writes them side by side, so that
/// the host waits for many at once.
template <class E>
class PartSums {
 public:
  explicit PartSums(E& executor) : executor_(executor), on_device_(executor, room) {}

  /// Returns the place of the next part's sums, which the device is to write.
  [[nodiscard]] PartnerCount* next() {
    if (written_ == room) collect();
    return on_device_.data() + written_++;
  }

  /// Waits: the pairs need memory, which is taken by the host.
  void collect() {
    if (written_ == 0) return;
    const std::size_t before = on_host_.size();
    on_host_.resize(before + written_);
    executor_.copy_to_host(on_host_.data() + before, on_device_.data(), written_);
    written_ = 0;
  }

  /// The sums that were collected.
  [[nodiscard]] const std::vector<PartnerCount>& on_host() const noexcept { return on_host_; }

 private:
  static constexpr std::uint64_t room = 32;

  E& executor_;
  Buffer<PartnerCount, E> on_device_;
  std::uint64_t written_ = 0;
  std::vector<PartnerCount> on_host_;
};

}  // namespace abut::device
