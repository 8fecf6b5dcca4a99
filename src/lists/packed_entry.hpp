#pragma once

#include "base/progress_reporter.hpp"
#include "lists/found_pairs.hpp"
#include "lists/pair_entry.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <algorithm>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// An entry of a range of rows with a short image shift, in one whole number whose order is that of
/// row, neighbor, shift. What sorts entries moves 8 bytes instead of the 20 of an ImagePair.
///
///   bit   63      48 47                 16 15 14   10 9     5 4     0
///         | row     | neighbor            |0 | x      | y     | z     |
///
/// The row counts from the first one of its range; 15 is added to the numbers of the shift, which
/// are from -15 to 15.
struct PackedEntry {
  std::uint64_t key;

  friend constexpr auto operator<=>(const PackedEntry&, const PackedEntry&) = default;
};

/// What can be sorted range by range.
template <class Entry>
concept RangeEntry = PairEntry<Entry> || std::same_as<Entry, PackedEntry>;

/// The element that rows count from in a range of elements from `first_element` on.
template <RangeEntry Entry>
[[nodiscard]] constexpr ElementIndex row_origin(std::size_t first_element) noexcept {
  return std::same_as<Entry, PackedEntry> ? 0 : static_cast<ElementIndex>(first_element);
}

inline constexpr std::int32_t longest_packed_shift = 15;

/// Tells whether a shift has room in a packed entry, as its opposite has then.
[[nodiscard]] constexpr bool can_be_packed(const ImageShift& shift) noexcept {
  const auto digit = [](std::int32_t number) {
    return static_cast<std::uint32_t>(number) + longest_packed_shift;
  };
  return std::max({digit(shift.x), digit(shift.y), digit(shift.z)}) <= 2 * longest_packed_shift;
}

/// Tells whether all shifts have.
[[nodiscard]] bool shifts_can_be_packed(const FoundPieces& pieces, std::size_t workers,
                                        base::WorkCounter& work);

/// `row` is the entry's first element in its range; the shift must have room.
[[nodiscard]] constexpr PackedEntry packed(std::uint16_t row, const ImagePair& entry) noexcept {
  const auto digit = [](std::int32_t number) -> std::uint64_t {
    const std::uint32_t from_zero = static_cast<std::uint32_t>(number) + longest_packed_shift;
    return from_zero;
  };
  const ImageShift& shift = entry.shift;
  return {std::uint64_t{row} << 48 | std::uint64_t{entry.pair.second} << 16 | digit(shift.x) << 10 |
          digit(shift.y) << 5 | digit(shift.z)};
}

/// The row in its range, and the neighbor.
[[nodiscard]] constexpr ContactPair pair_of(const PackedEntry& entry) noexcept {
  return {static_cast<ElementIndex>(entry.key >> 48), static_cast<ElementIndex>(entry.key >> 16)};
}

[[nodiscard]] constexpr bool comes_before(const PackedEntry& a, const PackedEntry& b) noexcept {
  return a.key < b.key;
}

inline void put_shift(const PackedEntry& entry, std::span<ImageShift> shifts,
                      std::size_t k) noexcept {
  const auto number = [&](int bit) {
    return static_cast<std::int32_t>(entry.key >> bit & 31U) - longest_packed_shift;
  };
  shifts[k] = {number(10), number(5), number(0)};
}

}  // namespace abut::lists
