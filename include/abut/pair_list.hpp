#pragma once

#include <abut/export.hpp>
#include <abut/image_shift.hpp>
#include <abut/pair.hpp>
#include <abut/statistics.hpp>

#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace abut {

namespace detail {

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

}  // namespace detail

/// Pairs in a row.
using PairArray = std::vector<ContactPair, detail::PageAllocator<ContactPair>>;

/// Image shifts in a row.
using ShiftArray = std::vector<ImageShift, detail::PageAllocator<ImageShift>>;

/// The contact pairs of one detection, each once, in the order that was asked for.
class PairList {
 public:
  PairList() = default;
  PairList(PairArray pairs, Statistics statistics)
      : pairs_(std::move(pairs)), statistics_(std::move(statistics)) {}
  PairList(PairArray pairs, ShiftArray shifts, Statistics statistics)
      : pairs_(std::move(pairs)), shifts_(std::move(shifts)), statistics_(std::move(statistics)) {}

  [[nodiscard]] PairCount size() const noexcept { return pairs_.size(); }
  [[nodiscard]] bool empty() const noexcept { return pairs_.empty(); }
  [[nodiscard]] const ContactPair& operator[](PairCount k) const noexcept { return pairs_[k]; }
  [[nodiscard]] auto begin() const noexcept { return pairs_.begin(); }
  [[nodiscard]] auto end() const noexcept { return pairs_.end(); }
  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }

  /// Of each pair the shift n for which `second`, moved by n, is within reach of `first`. Empty
  /// unless Options::shifts asks for them; zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  PairArray pairs_;
  ShiftArray shifts_;
  Statistics statistics_;
};

}  // namespace abut
