#pragma once

#include "base/opposite_shift.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// A pair with its image shift. What sorts pairs is written once, for entries of this type and for
/// pairs alone, which are the entries where shifts are not wanted.
struct ImagePair {
  ContactPair pair;
  ImageShift shift;

  friend constexpr auto operator<=>(const ImagePair&, const ImagePair&) = default;
};

template <class Entry>
concept PairEntry = std::same_as<Entry, ContactPair> || std::same_as<Entry, ImagePair>;

[[nodiscard]] constexpr const ContactPair& pair_of(const ContactPair& entry) noexcept {
  return entry;
}
[[nodiscard]] constexpr const ContactPair& pair_of(const ImagePair& entry) noexcept {
  return entry.pair;
}

/// Order by (first, second), in one comparison instead of two, the second of which would be a
/// guess; then by shift.
[[nodiscard]] constexpr bool comes_before(const ContactPair& a, const ContactPair& b) noexcept {
  const auto key_of = [](const ContactPair& pair) {
    return std::uint64_t{pair.first} << 32 | pair.second;
  };
  return key_of(a) < key_of(b);
}
[[nodiscard]] constexpr bool comes_before(const ImagePair& a, const ImagePair& b) noexcept {
  return comes_before(a.pair, b.pair) || (a.pair == b.pair && a.shift < b.shift);
}

/// The entry as it is seen from its second element.
[[nodiscard]] constexpr ContactPair reversed(const ContactPair& pair) noexcept {
  return {pair.second, pair.first};
}
[[nodiscard]] constexpr ImagePair reversed(const ImagePair& entry) noexcept {
  return {reversed(entry.pair), base::opposite(entry.shift)};
}

/// A pair with shift `k` of an array, if an entry of this type has a shift.
template <PairEntry Entry>
[[nodiscard]] Entry entry_of(const ContactPair& pair, std::span<const ImageShift> shifts,
                             std::size_t k) noexcept {
  if constexpr (std::same_as<Entry, ImagePair>) {
    return {pair, shifts[k]};
  } else {
    return pair;
  }
}

/// Writes the shift of an entry, if it has one.
inline void put_shift(const ContactPair&, std::span<ImageShift>, std::size_t) noexcept {}
inline void put_shift(const ImagePair& entry, std::span<ImageShift> shifts,
                      std::size_t k) noexcept {
  shifts[k] = entry.shift;
}

}  // namespace abut::lists
