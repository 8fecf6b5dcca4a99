#pragma once

#include <cstddef>

namespace abut::base {

/// Fetches the cache line behind the one that is about to be written to.
///
/// What is scattered to hundreds of ranges fills each of them from its begin to its end, but the
/// processor foresees some dozens of such streams only, and waits whenever one of the others comes
/// to a new line.
template <class T>
inline void fetch_next_line(T* place) noexcept {
  constexpr std::size_t line = 64;
  constexpr std::size_t ahead = sizeof(T) < line ? line / sizeof(T) : 1;
  __builtin_prefetch(place + ahead, 1);
}

}  // namespace abut::base
