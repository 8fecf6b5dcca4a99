#pragma once

#include "base/array.hpp"
#include "base/progress_reporter.hpp"

#include <abut/pair.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// Sorts pairs whose first elements lie in a narrow range: by counting, then by insertion, which
/// has next to nothing left to do. It keeps its arrays.
class BucketSort {
 public:
  explicit BucketSort(base::MemoryMeter& memory)
      : places_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        moved_(base::make_array_for_overwrite<ContactPair>(memory, 0)) {}

  /// First elements are first_element .. first_element + width - 1. Equal pairs may come.
  void sort(std::span<ContactPair> pairs, std::size_t first_element, std::size_t width,
            base::WorkCounter& work);

 private:
  template <class Digit>
  std::span<const std::uint32_t> scatter(std::span<const ContactPair> from, Digit digit,
                                         std::span<ContactPair> target, base::WorkCounter& work);

  base::Array<std::uint32_t> places_;
  base::Array<ContactPair> moved_;
};

}  // namespace abut::lists
