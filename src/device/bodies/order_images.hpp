#pragma once

#include "base/host_device.hpp"
#include "device/bodies/apart_pair.hpp"
#include "device/bodies/order_row.hpp"

#include <abut/image_shift.hpp>
#include <abut/pair.hpp>

#include <cstdint>

namespace abut::device {

/// Body: entry k is k.
struct FillInOrder {
  std::uint32_t* numbers;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    numbers[k] = static_cast<std::uint32_t>(k);
  }
};

/// Both numbers of a pair, each of so many bits. That of apart_pair has all of them.
[[nodiscard]] ABUT_HD inline std::uint64_t key_of_pair(const ContactPair& pair, int bits) noexcept {
  return static_cast<std::uint64_t>(pair.first) << bits | pair.second;
}

/// Body: the key of the pair that stands at place k.
struct PairKey {
  const ContactPair* pairs;
  const std::uint32_t* numbers;
  int bits;  ///< of a number
  std::uint64_t* keys;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    keys[k] = key_of_pair(pairs[numbers[k]], bits);
  }
};

/// Body: the pair of key k.
struct UnpackPair {
  const std::uint64_t* keys;
  int bits;
  ContactPair* pairs;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const std::uint64_t second = keys[k] & ((std::uint64_t{1} << bits) - 1);
    pairs[k] = {static_cast<std::uint32_t>(keys[k] >> bits), static_cast<std::uint32_t>(second)};
  }
};

/// Whole numbers without a sign in the order of those with one.
[[nodiscard]] ABUT_HD inline std::uint32_t ordered_bits(std::int32_t number) noexcept {
  return static_cast<std::uint32_t>(number) ^ (std::uint32_t{1} << 31);
}

/// Body: the key of a shift, its last two components or its first one.
struct ShiftKey {
  const ImageShift* shifts;
  const std::uint32_t* numbers;
  bool is_upper;
  std::uint64_t* keys;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    const ImageShift shift = shifts[numbers[k]];
    keys[k] = is_upper
                  ? ordered_bits(shift.x)
                  : static_cast<std::uint64_t>(ordered_bits(shift.y)) << 32 | ordered_bits(shift.z);
  }
};

/// Body: the shift that belongs at place k.
struct GatherShift {
  const ImageShift* shifts;
  const std::uint32_t* numbers;
  ImageShift* sorted;

  ABUT_HD void operator()(std::uint64_t k) const noexcept { sorted[k] = shifts[numbers[k]]; }
};

/// Body of a reduction: the pair of key k, in order, and how many times that key stands there, 0
/// where it does not begin.
struct SummaryOfImages {
  const std::uint64_t* keys;
  std::uint64_t count;
  int bits;  ///< of a number

  [[nodiscard]] ABUT_HD OrderSummary operator()(std::uint64_t k) const noexcept {
    if (keys[k] == key_of_pair(apart_pair(), bits)) return {};
    return {1, k > 0 && keys[k - 1] == keys[k] ? 0 : images_from(k)};
  }

 private:
  [[nodiscard]] ABUT_HD std::uint64_t images_from(std::uint64_t k) const noexcept {
    std::uint64_t images = 1;
    while (images <= longest_short_row && k + images < count && keys[k + images] == keys[k]) {
      ++images;
    }
    return images;
  }
};

/// Whether a shift comes before another one.
[[nodiscard]] ABUT_HD inline bool is_before(const ImageShift& a, const ImageShift& b) noexcept {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

/// Body: sorts the images of the pair that begins at place k by insertion.
struct OrderImages {
  const ContactPair* pairs;
  ImageShift* shifts;
  std::uint64_t count;

  ABUT_HD void operator()(std::uint64_t k) const noexcept {
    if (k > 0 && is_same(k - 1, k)) return;
    for (std::uint64_t next = k + 1; next < count && is_same(k, next); ++next) {
      const ImageShift shift = shifts[next];
      std::uint64_t place = next;
      for (; place > k && is_before(shift, shifts[place - 1]); --place) {
        shifts[place] = shifts[place - 1];
      }
      shifts[place] = shift;
    }
  }

 private:
  [[nodiscard]] ABUT_HD bool is_same(std::uint64_t a, std::uint64_t b) const noexcept {
    return pairs[a].first == pairs[b].first && pairs[a].second == pairs[b].second;
  }
};

}  // namespace abut::device
