#pragma once

#include <cstddef>
#include <cstdint>

namespace abut::engine {

/// The most memory of a search, in integers of four bytes: so many for each element, as many again
/// whatever their number is, and as many for each worker but the first.
inline constexpr std::size_t integers_of_element = 32;
inline constexpr std::size_t integers_of_search = 32768;
inline constexpr std::size_t integers_of_worker = 131072;

/// The same in bytes, with the elements themselves in one packed array.
template <int Dim>
[[nodiscard]] constexpr std::uint64_t most_bytes(std::size_t elements,
                                                 std::size_t workers) noexcept {
  constexpr std::uint64_t bytes_of_packed = (Dim + 1) * sizeof(double);
  const std::uint64_t integers = std::uint64_t{integers_of_element} * elements +
                                 integers_of_search + integers_of_worker * (workers - 1);
  return bytes_of_packed * elements + sizeof(std::uint32_t) * integers;
}

/// Half of it, which is much: what is searched next has yet to be held.
template <int Dim>
[[nodiscard]] constexpr std::uint64_t much_memory(std::size_t elements,
                                                  std::size_t workers) noexcept {
  return most_bytes<Dim>(elements, workers) / 2;
}

}  // namespace abut::engine
