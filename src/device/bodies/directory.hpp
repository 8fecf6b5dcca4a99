#pragma once

#include "base/host_device.hpp"

#include <cstdint>
#include <limits>

namespace abut::device {

/// Slots in the order of their keys, [first, end).
struct SlotRun {
  std::uint32_t first;
  std::uint32_t end;

  [[nodiscard]] ABUT_HD std::uint32_t size() const noexcept {
    return end > first ? end - first : 0;
  }
};

/// Sorted keys, and for each value of their top bits the first slot that has it or more. Its size
/// follows the number of elements, not that of cells; `shift` is 0 where there are few cells.
template <class Key>
struct Directory {
  const Key* keys;
  const std::uint32_t* heads;  ///< one for each value of key >> shift, and one behind
  int shift;

  /// The first slot whose key is `key` or more; `key` is at most the number of keys.
  [[nodiscard]] ABUT_HD std::uint32_t first_at(std::uint64_t key) const noexcept {
    const std::uint64_t prefix = key >> shift;
    std::uint32_t first = heads[prefix];
    if (shift == 0) return first;
    std::uint32_t end = heads[prefix + 1];
    while (first < end) {
      const std::uint32_t middle = first + (end - first) / 2;
      if (keys[middle] < key) {
        first = middle + 1;
      } else {
        end = middle;
      }
    }
    return first;
  }

  /// The slots of the cells with the keys [first, last].
  [[nodiscard]] ABUT_HD SlotRun cells(std::uint64_t first, std::uint64_t last) const noexcept {
    return {first_at(first), first_at(last + 1)};
  }
};

inline constexpr std::uint32_t unset_head = std::numeric_limits<std::uint32_t>::max();

/// Body: writes the heads that begin at this slot, as far as these are few.
template <class Key>
struct HeadsOfSlot {
  static constexpr std::uint64_t most = 16;

  const Key* keys;
  std::uint32_t* heads;  ///< all unset
  int shift;

  ABUT_HD void operator()(std::uint64_t slot) const noexcept {
    const auto prefix = static_cast<std::uint64_t>(keys[slot]) >> shift;
    std::uint64_t first = 0;
    if (slot > 0) first = (static_cast<std::uint64_t>(keys[slot - 1]) >> shift) + 1;
    if (prefix >= most && first < prefix - most + 1) first = prefix - most + 1;
    for (std::uint64_t k = first; k <= prefix; ++k) heads[k] = static_cast<std::uint32_t>(slot);
  }
};

/// Body: finds a head that no slot has written, before a long stretch of empty cells or behind all
/// slots.
template <class Key>
struct FindHead {
  const Key* keys;
  std::uint32_t count;
  std::uint32_t* heads;
  int shift;

  ABUT_HD void operator()(std::uint64_t prefix) const noexcept {
    if (heads[prefix] != unset_head) return;
    std::uint32_t first = 0;
    std::uint32_t end = count;
    while (first < end) {
      const std::uint32_t middle = first + (end - first) / 2;
      if (static_cast<std::uint64_t>(keys[middle]) >> shift < prefix) {
        first = middle + 1;
      } else {
        end = middle;
      }
    }
    heads[prefix] = first;
  }
};

/// Body: sets entry k of an array.
template <class T>
struct FillArray {
  T* values;
  T value;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { values[k] = value; }
};

/// Body: copies entry k of an array.
template <class T>
struct CopyEntry {
  const T* from;
  T* to;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { to[k] = from[k]; }
};

}  // namespace abut::device
