#pragma once

#include <cstdint>

/// Singly linked lists as the book keeps them: a head for each cell (row, layer) and one "next"
/// for each element.
namespace abut::reference {

/// End of a list, or an empty one (book: -1).
inline constexpr std::int32_t none = -1;

/// A head also tells whether its cell was treated ("old"). The book adds N to the head for that;
/// here the head h >= 0 becomes -2 - h, which needs no larger integers:
///
///   h >= 0   first element, not yet treated ("new")
///   -1       empty
///   h <= -2  first element -2 - h, treated ("old")
[[nodiscard]] constexpr bool is_old(std::int32_t head) noexcept {
  return head < none;
}
[[nodiscard]] constexpr std::int32_t as_old(std::int32_t head) noexcept {
  return -2 - head;
}
[[nodiscard]] constexpr std::int32_t first_of(std::int32_t head) noexcept {
  return is_old(head) ? -2 - head : head;
}

static_assert(first_of(as_old(0)) == 0 && is_old(as_old(0)) && first_of(none) == none);

}  // namespace abut::reference
