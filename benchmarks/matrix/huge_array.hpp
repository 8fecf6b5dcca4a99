#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

#include <sys/mman.h>

namespace abut::benchmarks {

/// Room for plain numbers or records, on huge pages where the system grants them; kept from run to
/// run. Growing forgets what was there, unless asked to keep it.
template <class T>
requires std::is_trivially_copyable_v<T>
class HugeArray {
 public:
  [[nodiscard]] T* data() noexcept { return data_.get(); }
  [[nodiscard]] const T* data() const noexcept { return data_.get(); }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  [[nodiscard]] std::size_t bytes() const noexcept { return capacity_ * sizeof(T); }

  void ensure(std::size_t count) {
    if (count <= capacity_) return;
    data_.reset();
    data_ = allocate(count);
    capacity_ = count;
  }

  /// At least `count`, growing by half or more; the first `used` stay.
  void grow(std::size_t count, std::size_t used) {
    if (count <= capacity_) return;
    count = std::max(count, capacity_ + capacity_ / 2);
    auto larger = allocate(count);
    std::copy_n(data_.get(), used, larger.get());
    data_ = std::move(larger);
    capacity_ = count;
  }

 private:
  struct Free {
    void operator()(T* data) const noexcept { std::free(data); }
  };
  using Memory = std::unique_ptr<T[], Free>;

  static Memory allocate(std::size_t count) {
    constexpr std::size_t huge_page = std::size_t{2} << 20;
    const std::size_t bytes = (count * sizeof(T) + huge_page - 1) / huge_page * huge_page;
    void* memory = std::aligned_alloc(huge_page, bytes);
    if (memory == nullptr) throw std::bad_alloc();
    madvise(memory, bytes, MADV_HUGEPAGE);
    return Memory(static_cast<T*>(memory));
  }

  Memory data_;
  std::size_t capacity_ = 0;
};

}  // namespace abut::benchmarks
