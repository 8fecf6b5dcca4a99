#pragma once

#include "base/array.hpp"
#include "base/asking_workers.hpp"

#include <abut/pair.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace abut::lists {

/// Ranges of elements, a power of two wide: few enough that each is written as a stream, and narrow
/// enough that the pairs of one lie in the cache.
class ElementRanges {
 public:
  explicit ElementRanges(std::size_t element_count) : element_count_(element_count) {
    const auto are_many = [&] {
      return (element_count >> shift_) >= (width() < enough ? fair_number : most);
    };
    while (shift_ < widest && are_many()) ++shift_;
    count_ = (element_count >> shift_) + 1;
  }

  [[nodiscard]] std::size_t count() const noexcept { return count_; }
  /// Most elements of a range, at most 2^16.
  [[nodiscard]] std::size_t width() const noexcept { return std::size_t{1} << shift_; }
  /// Number of elements in a range.
  [[nodiscard]] std::size_t size(std::size_t range) const noexcept {
    return std::min(width(), element_count_ - first_of(range));
  }
  [[nodiscard]] std::size_t of(ElementIndex element) const noexcept { return element >> shift_; }
  /// The number of an element in its range.
  [[nodiscard]] std::uint16_t in_range(ElementIndex element) const noexcept {
    return static_cast<std::uint16_t>(element & (width() - 1));
  }
  [[nodiscard]] std::size_t first_of(std::size_t range) const noexcept { return range << shift_; }

 private:
  /// What is scattered to two arrays at so many places still fits the first cache, and rows of so
  /// many elements the second one.
  static constexpr std::size_t fair_number = 256;
  static constexpr std::size_t enough = 4096;
  static constexpr std::size_t most = 1024;
  static constexpr int widest = 16;

  std::size_t element_count_;
  int shift_ = 11;
  std::size_t count_;
};

/// Places for entries sorted by range: first all workers count theirs, then all write, in any
/// order, since each range is sorted afterwards. It keeps its arrays.
class RangePlaces {
 public:
  explicit RangePlaces(base::MemoryMeter& memory)
      : next_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
        begin_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)) {}

  /// `for_each_entry(worker, work, count)` calls count(element) for each entry of the worker's
  /// share, and tells `work` how many there are.
  template <class ForEachEntry>
  void count(const ElementRanges& ranges, std::size_t workers, base::WorkCounter& work,
             ForEachEntry&& for_each_entry) {
    base::make_room(next_, workers * ranges.count());
    base::make_room(begin_, ranges.count() + 1);
    base::for_each_share(workers, work, [&](std::size_t worker, base::WorkCounter& its_work) {
      std::uint64_t* const own = next_.data() + worker * ranges.count();
      std::fill_n(own, ranges.count(), std::uint64_t{0});
      for_each_entry(worker, its_work,
                     [own, ranges](ElementIndex element) { ++own[ranges.of(element)]; });
    });
    std::uint64_t end = 0;
    for (std::size_t b = 0; b < ranges.count(); ++b) {
      begin_[b] = end;
      for (std::size_t w = 0; w < workers; ++w) {
        end += std::exchange(next_[w * ranges.count() + b], end);
      }
    }
    begin_[ranges.count()] = end;
  }

  /// Places of the worker's next entry in each range; the worker advances them.
  [[nodiscard]] std::uint64_t* next_of(const ElementRanges& ranges, std::size_t worker) noexcept {
    return next_.data() + worker * ranges.count();
  }

  [[nodiscard]] std::uint64_t begin(std::size_t range) const noexcept { return begin_[range]; }
  [[nodiscard]] std::uint64_t size(std::size_t range) const noexcept {
    return begin_[range + 1] - begin_[range];
  }

 private:
  base::Array<std::uint64_t> next_;
  base::Array<std::uint64_t> begin_;
};

}  // namespace abut::lists
