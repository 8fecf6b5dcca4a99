#pragma once

#include <abut/device.hpp>

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace abut::testing {

/// An allocator of the host that counts, and refuses what is larger than it is told.
struct MemorySource {
  std::uint64_t requests = 0;
  std::uint64_t largest = ~std::uint64_t{0};
  std::uint64_t most_at_once = ~std::uint64_t{0};
  std::uint64_t held = 0;
  std::vector<void*> streams;
  std::int64_t blocks = 0;

  device::Allocator functions() {
    return {[this](std::uint64_t bytes, device::Stream stream) -> void* {
              ++requests;
              streams.push_back(stream.handle);
              if (bytes > largest || held + bytes > most_at_once) return nullptr;
              void* const block = std::aligned_alloc(256, (bytes + 255) / 256 * 256);
              if (block == nullptr) return nullptr;
              held += bytes;
              ++blocks;
              return block;
            },
            [this](void* block, std::uint64_t bytes, device::Stream stream) {
              streams.push_back(stream.handle);
              held -= bytes;
              --blocks;
              std::free(block);
            }};
  }
};

}  // namespace abut::testing
