#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// The other element of a pair, and which of its images.
struct Partner {
  ElementIndex element = 0;
  ImageShift shift;

  friend constexpr auto operator<=>(const Partner&, const Partner&) = default;
};

/// Sorts pairs with their image shifts by (first, second, shift), as BucketSort does those without.
/// It keeps its arrays.
class ImageBucketSort {
 public:
  explicit ImageBucketSort(base::MemoryMeter& memory)
      : end_(base::make_array_for_overwrite<std::uint64_t>(memory, 0)),
        by_first_(base::make_array_for_overwrite<Partner>(memory, 0)) {}

  /// `shifts` runs parallel to `pairs`, which are distinct with them. First elements are
  /// first_element .. first_element + width - 1.
  void sort(std::span<ContactPair> pairs, std::span<ImageShift> shifts, std::size_t first_element,
            std::size_t width, base::WorkCounter& work);

 private:
  base::Array<std::uint64_t> end_;
  base::Array<Partner> by_first_;
};

}  // namespace abut::lists
