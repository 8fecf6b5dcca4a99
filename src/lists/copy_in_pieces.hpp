#pragma once

#include "base/progress_reporter.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace abut::lists {

/// Copies values to as many other places; each is a step of work.
template <class T>
void copy_in_pieces(std::span<const T> values, std::span<T> places, base::WorkCounter& work) {
  work.in_pieces(0, values.size(), [values, places](std::size_t begin, std::size_t end) {
    std::copy_n(values.data() + begin, end - begin, places.data() + begin);
  });
}

}  // namespace abut::lists
