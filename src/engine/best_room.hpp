#pragma once

#include <cstddef>

namespace abut::engine {

/// Of spare arrays, by pointers, the smallest that have room for so many but not much more; or else
/// the largest of the smaller ones, which grow; the end of the list where all are much larger.
template <class Arrays>
[[nodiscard]] auto best_room(Arrays& spares, std::size_t wanted) noexcept {
  const std::size_t most_room = 8 * wanted + 64;  // what is larger is left for what needs it
  auto best = spares.end();
  for (auto spare = spares.begin(); spare != spares.end(); ++spare) {
    const std::size_t room = (*spare)->room();
    if (room > most_room) continue;
    const std::size_t best_so_far = best == spares.end() ? 0 : (*best)->room();
    const bool fits = best_so_far >= wanted;
    const bool is_better = fits ? room >= wanted && room < best_so_far : room > best_so_far;
    if (best == spares.end() || is_better) best = spare;
  }
  return best;
}

}  // namespace abut::engine
