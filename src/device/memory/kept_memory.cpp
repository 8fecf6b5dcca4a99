#include "device/memory/kept_memory.hpp"

#include <abut/error.hpp>

#include <string>

namespace abut::device {
namespace {

/// What CUDA aligns its blocks to.
constexpr std::uint64_t alignment = 256;

std::uint64_t aligned(std::uint64_t bytes) {
  return (bytes + alignment - 1) / alignment * alignment;
}

}  // namespace

void KeptMemory::begin(std::uint64_t max_bytes, Stream stream) {
  const std::uint64_t needed = places_.length();
  // Work in another stream is in no order with what still uses the array.
  const bool is_of_use =
      array_bytes_ >= needed && array_bytes_ <= max_bytes && stream.handle == stream_.handle;
  if (!is_of_use) release_array();
  start(max_bytes, stream);
  if (array_ == nullptr && needed > 0 && needed <= max_bytes) take_array(needed);
}

void KeptMemory::start(std::uint64_t max_bytes, Stream stream) {
  stream_ = stream;
  places_ = {};
  was_short_ = false;
  meter_.start_anew(max_bytes);
}

void* KeptMemory::take(std::uint64_t bytes) {
  const std::uint64_t place = places_.lowest_gap(aligned(bytes));
  if (place + aligned(bytes) > array_bytes_) return take_beside(bytes, place);
  places_.take(place, aligned(bytes));
  return array_ + place;
}

/// What could not be had takes no place, or the next call would ask for an array that holds it.
void* KeptMemory::take_beside(std::uint64_t bytes, std::uint64_t place) {
  was_short_ = true;
  void* const block = allocate(bytes);
  if (block == nullptr) return nullptr;
  was_short_ = false;
  try {
    places_.take(place, aligned(bytes));
    beside_.emplace(block, place);
  } catch (...) {
    places_.give_back(place);
    release(block, bytes);
    throw;
  }
  return block;
}

void KeptMemory::give_back(void* block, std::uint64_t bytes) noexcept {
  const auto found = beside_.find(block);
  if (found == beside_.end()) {
    places_.give_back(static_cast<std::uint64_t>(static_cast<std::byte*>(block) - array_));
    return;
  }
  places_.give_back(found->second);
  beside_.erase(found);
  release(block, bytes);
}

void KeptMemory::release_array() noexcept {
  if (array_ == nullptr) return;
  release(array_, array_bytes_);
  array_ = nullptr;
  array_bytes_ = 0;
}

/// Without the array blocks are taken one by one: nothing is lost but time.
void KeptMemory::take_array(std::uint64_t bytes) {
  array_ = static_cast<std::byte*>(allocate(bytes));
  if (array_ != nullptr) array_bytes_ = bytes;
}

void* KeptMemory::allocate(std::uint64_t bytes) {
  meter_.take(bytes);
  void* block = nullptr;
  try {
    block = allocator_.allocate(bytes, stream_);
  } catch (...) {
    meter_.give_back(bytes);
    throw;
  }
  if (block == nullptr) {
    meter_.give_back(bytes);
  } else if (reinterpret_cast<std::uintptr_t>(block) % alignment != 0) {
    release(block, bytes);
    throw Error(ErrorCode::wrong_usage, "the allocator gave " + std::to_string(bytes) +
                                            " bytes at an address that is no multiple of " +
                                            std::to_string(alignment) +
                                            "; align its blocks to that");
  }
  return block;
}

void KeptMemory::release(void* block, std::uint64_t bytes) noexcept {
  allocator_.release(block, bytes, stream_);
  meter_.give_back(bytes);
}

}  // namespace abut::device
