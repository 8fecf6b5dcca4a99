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

/// Array of pairs.
using PairArray = std::vector<ContactPair, detail::PageAllocator<ContactPair>>;

/// Array of image shifts.
using ShiftArray = std::vector<ImageShift, detail::PageAllocator<ImageShift>>;

/// The contact pairs of one detection, each once, in the order that was asked for.
class PairList {
 public:
  /// Makes an empty list.
  PairList() = default;
  /// Makes a list without shifts; called by the library.
  PairList(PairArray pairs, Statistics statistics)
      : pairs_(std::move(pairs)), statistics_(std::move(statistics)) {}
  /// Makes a list with shifts; called by the library.
  PairList(PairArray pairs, ShiftArray shifts, Statistics statistics)
      : pairs_(std::move(pairs)), shifts_(std::move(shifts)), statistics_(std::move(statistics)) {}

  /// Number of pairs.
  [[nodiscard]] PairCount size() const noexcept { return pairs_.size(); }
  /// True if there is no pair.
  [[nodiscard]] bool empty() const noexcept { return pairs_.empty(); }
  /// Pair k, from 0; k must be < size().
  [[nodiscard]] const ContactPair& operator[](PairCount k) const noexcept { return pairs_[k]; }
  /// Iterator to the first pair.
  [[nodiscard]] auto begin() const noexcept { return pairs_.begin(); }
  /// Iterator behind the last pair.
  [[nodiscard]] auto end() const noexcept { return pairs_.end(); }
  /// All pairs.
  [[nodiscard]] std::span<const ContactPair> pairs() const noexcept { return pairs_; }

  /// Image shifts n, one for each pair: `second`, moved by n, is within reach of `first`. Empty
  /// unless Options::shifts asks for them; zeros in an open domain.
  [[nodiscard]] std::span<const ImageShift> shifts() const noexcept { return shifts_; }

  /// Statistics of the detection that found the pairs.
  [[nodiscard]] const Statistics& statistics() const noexcept { return statistics_; }

 private:
  friend class Detector;

  PairArray pairs_;
  ShiftArray shifts_;
  Statistics statistics_;
};

}  // namespace abut
