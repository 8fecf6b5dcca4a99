#pragma once

#include "base/memory_meter.hpp"
#include "device/block_places.hpp"

#include <abut/device.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace abut::device {

/// The memory that one detector takes from an allocator, counted. A call learns how long one array
/// for all of its blocks would be; the next takes that array at once and keeps it, so that calls
/// which need no more than the one before allocate nothing.
class KeptMemory {
 public:
  explicit KeptMemory(Allocator allocator) : allocator_(std::move(allocator)) {}
  ~KeptMemory() { release_array(); }
  KeptMemory(const KeptMemory&) = delete;
  KeptMemory& operator=(const KeptMemory&) = delete;

  /// Begins a call in a stream. All blocks of the call before have been given back.
  void begin(std::uint64_t max_bytes, Stream stream);

  /// Memory for what is put into the stream from now on; null if the allocator has none. Throws
  /// Error{limit_exceeded} where the bound of the call would be passed.
  [[nodiscard]] void* take(std::uint64_t bytes);
  void give_back(void* block, std::uint64_t bytes) noexcept;

  /// Most bytes held at once in this call, those of the array included.
  [[nodiscard]] std::uint64_t peak() const noexcept { return meter_.peak(); }
  [[nodiscard]] std::uint64_t held() const noexcept { return meter_.held(); }

 private:
  void release_array() noexcept;
  void take_array(std::uint64_t bytes);
  [[nodiscard]] void* allocate(std::uint64_t bytes);

  Allocator allocator_;
  base::MemoryMeter meter_;
  Stream stream_;
  BlockPlaces places_;  ///< of this call's blocks in the array, whether it is long enough or not
  std::byte* array_ = nullptr;
  std::uint64_t array_bytes_ = 0;
  std::map<void*, std::uint64_t> beside_;  ///< places of blocks that the array was too short for
};

}  // namespace abut::device
