#pragma once

#include <abut/device.hpp>
#include <abut/device_elements.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace abut::testing {

/// An allocator that cuts its blocks from one array of the device, which it gets as a column of
/// numbers: no program that uses the face needs CUDA for it. Each place is given out once.
class CountingAllocator {
 public:
  explicit CountingAllocator(std::uint64_t bytes)
      : numbers_(bytes / sizeof(double)), array_(discs(numbers_, numbers_, 1.0)) {}

  [[nodiscard]] device::Allocator functions() {
    return {[this](std::uint64_t bytes, device::Stream) { return allocate(bytes); },
            [this](void* block, std::uint64_t bytes, device::Stream) { release(block, bytes); }};
  }

  void refuse_request(std::uint64_t number) {
    requests = 0;
    refused_ = number;
  }

  std::uint64_t requests = 0;  ///< since the last call of refuse_request
  std::uint64_t held_bytes = 0;
  std::uint64_t most_bytes = 0;

 private:
  static constexpr std::uint64_t alignment = 256;

  void* allocate(std::uint64_t bytes) {
    if (requests++ == refused_) return nullptr;
    const std::uint64_t room = (bytes + alignment - 1) / alignment * alignment;
    // The first gap that is wide enough.
    std::uint64_t place = 0;
    for (const auto& [begin, end] : blocks_) {
      if (begin - place >= room) break;
      place = end;
    }
    if (place + room > numbers_.size() * sizeof(double)) return nullptr;
    blocks_[place] = place + room;
    held_bytes += bytes;
    most_bytes = std::max(most_bytes, held_bytes);
    return const_cast<std::byte*>(array_.elements().center(0).first) + place;
  }

  void release(void* block, std::uint64_t bytes) {
    const auto place = static_cast<std::uint64_t>(static_cast<std::byte*>(block) -
                                                  array_.elements().center(0).first);
    EXPECT_EQ(blocks_.erase(place), 1U) << "a block that nobody has";
    held_bytes -= bytes;
  }

  std::vector<double> numbers_;
  device::ElementCopy array_;
  std::map<std::uint64_t, std::uint64_t> blocks_;
  std::uint64_t refused_ = ~std::uint64_t{0};
};

/// Bytes for what is tested with it.
inline constexpr std::uint64_t enough = std::uint64_t{16} << 20;

}  // namespace abut::testing
