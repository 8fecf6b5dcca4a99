#pragma once

#include "base/array.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::api {

/// Whether equal pairs may come, for several images of one element.
enum class Repeats { never, possible };

/// Counting sort by the first element, then each element's few partners. It keeps its arrays.
class BucketSort {
 public:
  explicit BucketSort(base::MemoryMeter& memory)
      : end_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        by_first_(base::make_array_for_overwrite<ContactPair>(memory, 0)) {}

  /// First elements are first_element .. first_element + width - 1.
  void sort(std::span<ContactPair> pairs, std::size_t first_element, std::size_t width,
            Repeats repeats = Repeats::never);

 private:
  base::Array<std::uint32_t> end_;
  base::Array<ContactPair> by_first_;
};

}  // namespace abut::api
