#pragma once

#include "base/memory_meter.hpp"

#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace abut::base {

/// Allocates as std::allocator does and tells a MemoryMeter, which must outlive the container.
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
      return std::allocator<T>().allocate(count);
    } catch (...) {
      meter_->give_back(count * sizeof(T));
      throw;
    }
  }
  void deallocate(T* first, std::size_t count) noexcept {
    std::allocator<T>().deallocate(first, count);
    meter_->give_back(count * sizeof(T));
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
[[nodiscard]] Array<T> make_array(MemoryMeter& meter, std::size_t size, const T& value = T{}) {
  return Array<T>(size, value, MeteredAllocator<T>(meter));
}

}  // namespace abut::base
