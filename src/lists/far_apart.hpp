#pragma once

#include "base/progress_reporter.hpp"

#include <cstddef>

namespace abut::lists {

/// Calls visit(k) for each k of [0, count), so that calls in a row are for numbers far apart.
///
/// Who counts entries by row, or writes each to the next place of its row, waits where a counter
/// was written just before: some ten cycles an entry where entries that lie together are of the
/// same row, as they are when elements are numbered in the order of space. Four streams through the
/// entries, by turns, touch other counters in between.
///
///   | 0, 4, 8, ... | 1, 5, 9, ... | 2, 6, 10, ... | 3, 7, 11, ... |    calls
///   0              count / 4                                    count
template <class Visit>
void for_each_far_apart(std::size_t count, base::WorkCounter& work, Visit&& visit_each) {
  constexpr std::size_t streams = 4;
  const std::size_t length = count / streams;
  work.in_pieces(0, length, [&](std::size_t begin, std::size_t end) {
    // A copy: the compiler knows that no write below changes it.
    const auto visit = visit_each;
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t stream = 0; stream < streams; ++stream) visit(k + stream * length);
    }
    work.did((streams - 1) * (end - begin));
  });
  for (std::size_t k = streams * length; k < count; ++k) visit_each(k);
}

}  // namespace abut::lists
