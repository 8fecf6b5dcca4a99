#pragma once

#include "base/memory_meter.hpp"
#include "device/memory/block_places.hpp"

#include <abut/device.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace abut::device {

/// The memory that one detector takes from an allocator, counted. A call learns how long one array
/// for all of its blocks would be; the next takes that array at once and keeps it, so that calls
/// which need no more than the one before allocate nothing. Blocks that the array is too short for
/// lie beside it.
class KeptMemory {
 public:
  explicit KeptMemory(Allocator allocator) : allocator_(std::move(allocator)) {}
  ~KeptMemory() { release_array(); }
  KeptMemory(const KeptMemory&) = delete;
  KeptMemory& operator=(const KeptMemory&) = delete;

  /// Begins a call in a stream. All blocks of the call before have been given back.
  void begin(std::uint64_t max_bytes, Stream stream);

  /// Begins a call in a stream and runs it. Where memory did not suffice beside the array of the
  /// call before, that is released and the call is run once more: it ends as if it were the first.
  template <class Call>
  auto run(std::uint64_t max_bytes, Stream stream, const Call& call) {
    begin(max_bytes, stream);
    if (array_ == nullptr) return call();
    try {
      return call();
    } catch (...) {
      if (!was_short_) throw;
    }
    release_array();
    start(max_bytes, stream);
    return call();
  }

  /// Gives the array back.
  void release_array() noexcept;

  /// Memory for what is put into the stream from now on; null if the allocator has none. Throws
  /// Error{limit_exceeded} where the bound of the call would be passed, and Error{wrong_usage} for
  /// a block that is not aligned.
  [[nodiscard]] void* take(std::uint64_t bytes);
  void give_back(void* block, std::uint64_t bytes) noexcept;

  /// Most bytes held at once in this call, those of the array included.
  [[nodiscard]] std::uint64_t peak() const noexcept { return meter_.peak(); }
  [[nodiscard]] std::uint64_t held() const noexcept { return meter_.held(); }

 private:
  void start(std::uint64_t max_bytes, Stream stream);
  [[nodiscard]] void* take_beside(std::uint64_t bytes, std::uint64_t place);
  void take_array(std::uint64_t bytes);
  [[nodiscard]] void* allocate(std::uint64_t bytes);
  void release(void* block, std::uint64_t bytes) noexcept;

  Allocator allocator_;
  base::MemoryMeter meter_;
  Stream stream_;
  BlockPlaces places_;  ///< of this call's blocks in the array, whether it is long enough or not
  std::byte* array_ = nullptr;
  std::uint64_t array_bytes_ = 0;
  bool was_short_ = false;                 ///< the last block of the call could not be had
  std::map<void*, std::uint64_t> beside_;  ///< places of blocks that the array was too short for
};

}  // namespace abut::device
