#pragma once

#include "base/memory_meter.hpp"
#include "device/memory/block_places.hpp"
#include "device/memory/block_plans.hpp"
#include "device/memory/block_sequence.hpp"

#include <abut/device.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace abut::device {

/// The memory that one detector takes from an allocator, counted. From the first call it learns
/// where the blocks of such calls lie best in one array; the next takes that array at once and
/// keeps it, so that calls which need no more than the one before allocate nothing. Blocks that do
/// not fit there lie beside it, and then it learns from that call as well.
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
      if (!was_short_) {
        needs_plan_ = false;  // a call that ended early tells little of others
        throw;
      }
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
  /// A block that a call has.
  struct KeptBlock {
    std::size_t number;  ///< in the sequence
    bool is_beside;      ///< the array, and not in it
  };

  void learn() noexcept;
  void start(std::uint64_t max_bytes, Stream stream);
  [[nodiscard]] void* take_block(std::uint64_t bytes, std::size_t number);
  [[nodiscard]] void* take_beside(std::uint64_t bytes, std::size_t number);
  void take_array(std::uint64_t bytes);
  [[nodiscard]] void* allocate(std::uint64_t bytes);
  void release(void* block, std::uint64_t bytes) noexcept;

  Allocator allocator_;
  base::MemoryMeter meter_;
  Stream stream_;
  BlockSequence sequence_;  ///< of this call
  BlockPlans plans_;        ///< of the array
  BlockPlaces places_;      ///< of this call's blocks in the array
  std::map<void*, KeptBlock> held_;
  std::byte* array_ = nullptr;
  std::uint64_t array_bytes_ = 0;
  bool was_short_ = false;   ///< the last block of the call could not be had
  bool needs_plan_ = false;  ///< a block of the call lay beside the array
};

}  // namespace abut::device
