#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"
#include "lists/packed_entry.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// Sorts pairs whose first elements lie in a narrow range: by counting, then by insertion, which
/// has next to nothing left to do. It keeps its arrays.
template <RangeEntry Entry>
class BucketSort {
 public:
  explicit BucketSort(base::MemoryMeter& memory)
      : places_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        moved_(base::make_array_for_overwrite<Entry>(memory, 0)) {}

  /// First elements are first_element .. first_element + width - 1, counted from row_origin().
  /// Equal entries may come.
  void sort(std::span<Entry> entries, std::size_t first_element, std::size_t width,
            base::WorkCounter& work);

 private:
  [[nodiscard]] std::span<std::uint32_t> no_places(std::size_t digits);
  template <class Digit>
  std::span<const std::uint32_t> scatter(std::span<const Entry> from, const Digit& digit,
                                         std::span<Entry> target, base::WorkCounter& work);
  template <class Digit>
  void scatter_stably(std::span<const Entry> from, const Digit& digit, std::span<Entry> target,
                      base::WorkCounter& work);

  base::Array<std::uint32_t> places_;
  base::Array<Entry> moved_;
};

}  // namespace abut::lists
