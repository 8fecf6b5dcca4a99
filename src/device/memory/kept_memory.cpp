#include "device/memory/kept_memory.hpp"

#include <abut/error.hpp>

#include <new>
#include <string>

namespace abut::device {

void KeptMemory::begin(std::uint64_t max_bytes, Stream stream) {
  learn();
  const std::uint64_t needed = plans_.length();
  // Work in another stream is in no order with what still uses the array.
  const bool is_of_use =
      array_bytes_ >= needed && array_bytes_ <= max_bytes && stream.handle == stream_.handle;
  if (!is_of_use) release_array();
  start(max_bytes, stream);
  if (array_ == nullptr && needed > 0 && needed <= max_bytes) take_array(needed);
}

/// Plans for calls like the last, unless these are at home in the array. Memory of the host that
/// cannot be had for that costs nothing but a plan.
void KeptMemory::learn() noexcept {
  if (!needs_plan_) return;
  try {
    if (array_ == nullptr) {
      plans_.plan_for(sequence_);
    } else {
      plans_.plan_also_for(sequence_, array_bytes_);
    }
  } catch (const std::bad_alloc&) {
    // The last plan stays.
  }
}

void KeptMemory::start(std::uint64_t max_bytes, Stream stream) {
  stream_ = stream;
  sequence_.forget_all();
  plans_.restart();
  places_ = {};
  was_short_ = false;
  needs_plan_ = false;
  meter_.start_anew(max_bytes);
}

/// What could not be had is no part of the sequence, or the next call would ask for an array that
/// holds it.
void* KeptMemory::take(std::uint64_t bytes) {
  const std::size_t number = sequence_.take(bytes);
  try {
    void* const block = take_block(bytes, number);
    if (block == nullptr) sequence_.forget_last();
    return block;
  } catch (...) {
    sequence_.forget_last();
    throw;
  }
}

void* KeptMemory::take_block(std::uint64_t bytes, std::size_t number) {
  if (array_ == nullptr) return take_beside(bytes, number);
  const std::uint64_t place = plans_.place_for_last(sequence_, places_, array_bytes_);
  if (place + aligned_block(bytes) > array_bytes_) return take_beside(bytes, number);
  places_.take(place, aligned_block(bytes));
  try {
    held_.emplace(array_ + place, KeptBlock{number, false});
  } catch (...) {
    places_.give_back(place);
    throw;
  }
  sequence_.place(number, place);
  return array_ + place;
}

void* KeptMemory::take_beside(std::uint64_t bytes, std::size_t number) {
  was_short_ = true;
  void* const block = allocate(bytes);
  if (block == nullptr) return nullptr;
  was_short_ = false;
  try {
    held_.emplace(block, KeptBlock{number, true});
  } catch (...) {
    release(block, bytes);
    throw;
  }
  needs_plan_ = true;
  return block;
}

void KeptMemory::give_back(void* block, std::uint64_t bytes) noexcept {
  const auto found = held_.find(block);
  sequence_.give_back(found->second.number);
  if (found->second.is_beside) {
    release(block, bytes);
  } else {
    places_.give_back(static_cast<std::uint64_t>(static_cast<std::byte*>(block) - array_));
  }
  held_.erase(found);
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
  } else if (reinterpret_cast<std::uintptr_t>(block) % block_alignment != 0) {
    release(block, bytes);
    throw Error(ErrorCode::wrong_usage, "the allocator gave " + std::to_string(bytes) +
                                            " bytes at an address that is no multiple of " +
                                            std::to_string(block_alignment) +
                                            "; align its blocks to that");
  }
  return block;
}

void KeptMemory::release(void* block, std::uint64_t bytes) noexcept {
  allocator_.release(block, bytes, stream_);
  meter_.give_back(bytes);
}

}  // namespace abut::device
