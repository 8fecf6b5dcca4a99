#pragma once

#include <abut/export.hpp>

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>

namespace abut::detail {

/// Blocks that the system backs with large pages where it grants them. Throws std::bad_alloc.
[[nodiscard]] ABUT_API void* allocate_pages(std::size_t bytes);
ABUT_API void free_pages(void* block) noexcept;

/// Large pages, and no zeros written where pairs are written next.
template <class T>
struct PageAllocator {
  using value_type = T;

  PageAllocator() = default;
  template <class U>
  PageAllocator(const PageAllocator<U>&) noexcept {}

  [[nodiscard]] T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / sizeof(T)) throw std::bad_array_new_length();
    return static_cast<T*>(allocate_pages(count * sizeof(T)));
  }
  void deallocate(T* first, std::size_t) noexcept { free_pages(first); }

  /// Leaves the memory as it is: what a detection stores is written once.
  template <class U>
  void construct(U*) noexcept {
    static_assert(std::is_trivially_copyable_v<U>);
  }
  template <class U, class... Values>
  void construct(U* place, Values&&... values) {
    ::new (static_cast<void*>(place)) U{std::forward<Values>(values)...};
  }

  friend bool operator==(const PageAllocator&, const PageAllocator&) noexcept { return true; }
};

}  // namespace abut::detail
