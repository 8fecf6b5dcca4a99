#pragma once

#include "base/progress_reporter.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>

namespace abut::base {

/// std::sort for any number of values: tells how many comparisons it makes. What stands in the
/// range after an exception are some of the values.
template <class Iterator, class Less = std::less<>>
void sort_asking(Iterator first, Iterator last, WorkCounter& work, Less less = {}) {
  constexpr std::uint32_t comparisons_between_tells = 4096;
  std::uint32_t comparisons = 0;
  std::sort(first, last, [&](const auto& a, const auto& b) {
    if (++comparisons == comparisons_between_tells) {
      comparisons = 0;
      work.did(comparisons_between_tells);
    }
    return less(a, b);
  });
  work.did(comparisons);
}

}  // namespace abut::base
