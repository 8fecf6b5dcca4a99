#pragma once

#include <cstddef>

namespace abut::engine {

/// Room for so many, at most: what is larger is left for what needs it.
[[nodiscard]] constexpr std::size_t most_room_for(std::size_t wanted) noexcept {
  return 8 * wanted + 64;
}

/// Of spare arrays, by pointers, the smallest that have room for so many but not much more; or else
/// the largest of the smaller ones, which grow; the end of the list where all are much larger.
template <class Arrays>
[[nodiscard]] auto best_room(Arrays& spares, std::size_t wanted) noexcept {
  auto best = spares.end();
  for (auto spare = spares.begin(); spare != spares.end(); ++spare) {
    const std::size_t room = (*spare)->room();
    if (room > most_room_for(wanted)) continue;
    const std::size_t best_so_far = best == spares.end() ? 0 : (*best)->room();
    const bool fits = best_so_far >= wanted;
    const bool is_better = fits ? room >= wanted && room < best_so_far : room > best_so_far;
    if (best == spares.end() || is_better) best = spare;
  }
  return best;
}

}  // namespace abut::engine
