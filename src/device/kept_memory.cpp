#include "device/kept_memory.hpp"

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
  stream_ = stream;
  places_ = {};
  meter_.start_anew(max_bytes);
  if (array_ == nullptr && needed > 0 && needed <= max_bytes) take_array(needed);
}

void* KeptMemory::take(std::uint64_t bytes) {
  const std::uint64_t place = places_.take(aligned(bytes));
  if (place + aligned(bytes) <= array_bytes_) return array_ + place;
  try {
    void* const block = allocate(bytes);
    if (block != nullptr) {
      beside_.emplace(block, place);
      return block;
    }
  } catch (...) {
    places_.give_back(place);
    throw;
  }
  places_.give_back(place);
  return nullptr;
}

void KeptMemory::give_back(void* block, std::uint64_t bytes) noexcept {
  const auto found = beside_.find(block);
  if (found == beside_.end()) {
    places_.give_back(static_cast<std::uint64_t>(static_cast<std::byte*>(block) - array_));
    return;
  }
  places_.give_back(found->second);
  beside_.erase(found);
  allocator_.release(block, bytes, stream_);
  meter_.give_back(bytes);
}

void KeptMemory::release_array() noexcept {
  if (array_ == nullptr) return;
  allocator_.release(array_, array_bytes_, stream_);
  meter_.give_back(array_bytes_);
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
  try {
    if (void* const block = allocator_.allocate(bytes, stream_)) return block;
  } catch (...) {
    meter_.give_back(bytes);
    throw;
  }
  meter_.give_back(bytes);
  return nullptr;
}

}  // namespace abut::device
