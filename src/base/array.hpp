#pragma once

#include "base/memory_meter.hpp"
#include "base/page_memory.hpp"

#include <cstddef>
#include <new>
#include <vector>

namespace abut::base {

/// Allocates page memory and tells a MemoryMeter, which must outlive the container.
template <class T>
class MeteredAllocator {
 public:
  using value_type = T;

  explicit MeteredAllocator(MemoryMeter& meter) noexcept : meter_(&meter) {}
  template <class U>
  MeteredAllocator(const MeteredAllocator<U>& other) noexcept : meter_(&other.meter()) {}

  T* allocate(std::size_t count) {
    meter_->take(count * sizeof(T));
    try {
      return static_cast<T*>(allocate_pages(count * sizeof(T)));
    } catch (...) {
      meter_->give_back(count * sizeof(T));
      throw;
    }
  }
  void deallocate(T* first, std::size_t count) noexcept {
    free_pages(first);
    meter_->give_back(count * sizeof(T));
  }

  /// Elements without a value given are left as they are: arrays that are overwritten at once need
  /// no zeros first.
  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class Value>
  void construct(U* place, Value&& value) noexcept {
    ::new (static_cast<void*>(place)) U(static_cast<Value&&>(value));
  }

  [[nodiscard]] MemoryMeter& meter() const noexcept { return *meter_; }

  friend bool operator==(const MeteredAllocator& a, const MeteredAllocator& b) noexcept {
    return a.meter_ == b.meter_;
  }

 private:
  MemoryMeter* meter_;
};

/// A std::vector whose bytes count towards a detection's memory bound and peak.
template <class T>
using Array = std::vector<T, MeteredAllocator<T>>;

template <class T>
[[nodiscard]] Array<T> make_array(MemoryMeter& meter, std::size_t size, const T& value) {
  return Array<T>(size, value, MeteredAllocator<T>(meter));
}

/// Makes an array whose every element is written before it is read.
template <class T>
[[nodiscard]] Array<T> make_array_for_overwrite(MemoryMeter& meter, std::size_t size) {
  return Array<T>(size, MeteredAllocator<T>(meter));
}

/// An array of at least `size` elements of any value. What was there is dropped where it must grow,
/// before more is allocated; it never shrinks, so that a second use allocates nothing.
template <class T>
void make_room(Array<T>& array, std::size_t size) {
  if (array.size() >= size) return;
  array.clear();
  array.shrink_to_fit();
  array.resize(size);
}

/// Makes room for `size` values. An array that was used before gets an eighth more: results that
/// grow a little from step to step would be written into fresh memory each time, which the system
/// must find and clear, and that takes longer than writing them. What is never written to takes
/// addresses and, as most systems are set, no memory; where the eighth cannot be had, it is not
/// needed.
template <class Values>
void reserve_to_grow(Values& values, std::size_t size) {
  if (values.capacity() >= size) return;
  if (values.capacity() != 0) {
    try {
      return values.reserve(size + size / 8);
    } catch (const std::bad_alloc&) {
    }
  }
  values.reserve(size);
}

/// Gives the memory of an array back; it is empty then.
template <class T>
void give_back(Array<T>& array) noexcept {
  Array<T>(array.get_allocator()).swap(array);
}

/// Exactly `size` elements of any value, likewise.
template <class T>
void resize_for_overwrite(Array<T>& array, std::size_t size) {
  if (array.capacity() < size) array.clear();
  array.resize(size);
}

}  // namespace abut::base
