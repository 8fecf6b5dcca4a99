#pragma once

#include <abut/device.hpp>

#include <cstdint>
#include <new>

namespace abut::testing {

/// An allocator of the host, with blocks as CUDA aligns them.
[[nodiscard]] inline device::Allocator memory_of_the_host() {
  constexpr std::align_val_t alignment{256};
  return {[](std::uint64_t bytes, device::Stream) { return ::operator new(bytes, alignment); },
          [](void* block, std::uint64_t, device::Stream) { ::operator delete(block, alignment); }};
}

}  // namespace abut::testing
