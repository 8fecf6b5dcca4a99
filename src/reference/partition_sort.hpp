#pragma once

#include "base/progress_reporter.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

/// The partition sort of A. Munjiza, The Combined Finite-Discrete Element Method, Wiley 2004,
/// p. 99-102, Figures 3.28 to 3.38: exchange in place around the middle of the *values*.
namespace abut::reference {

/// The value at which those from `lowest` to `highest` > `lowest` are split: left is what is below.
/// The book's truncated mean, but never `lowest` itself, which for values {1, 2} would split off
/// nothing for ever. 1..16 gives 8.
[[nodiscard]] constexpr std::int32_t partition_middle(std::int32_t lowest,
                                                      std::int32_t highest) noexcept {
  const std::int64_t range = std::int64_t{highest} - lowest;
  return static_cast<std::int32_t>(lowest + std::max(std::int64_t{1}, range / 2));
}

/// Arrays that are sorted together: position k of all of them is one record.
template <std::size_t Keys>
class CompanionArrays {
 public:
  explicit CompanionArrays(std::array<std::span<std::int32_t>, Keys> keys) : keys_(keys) {}

  /// Sorts positions [first, last) by key `key`, then by those that follow. At most 31 levels deep
  /// for each key: the range of values halves each time.
  void sort(std::size_t first, std::size_t last, base::WorkCounter& work, std::size_t key = 0) {
    if (last - first < 2 || key == Keys) return;
    const auto [lowest, highest] = range_of(first, last, key, work);
    if (lowest == highest) return sort(first, last, work, key + 1);
    const std::size_t split = exchange(first, last, key, partition_middle(lowest, highest), work);
    sort(first, split, work, key);
    sort(split, last, work, key);
  }

  /// Brings the records whose key is below `middle` to the left and returns where the right begins.
  std::size_t exchange(std::size_t first, std::size_t last, std::size_t key, std::int32_t middle,
                       base::WorkCounter& work) {
    const std::span<std::int32_t> value = keys_[key];
    std::size_t left = first;
    std::size_t right = last;
    while (true) {
      for (; left < right && value[left] < middle; ++left) work.did(1);
      for (; left < right && value[right - 1] >= middle; --right) work.did(1);
      if (left == right) return left;
      --right;
      for (const std::span<std::int32_t> array : keys_) std::swap(array[left], array[right]);
      ++left;
    }
  }

 private:
  /// The least and the greatest value of a key.
  [[nodiscard]] std::pair<std::int32_t, std::int32_t> range_of(std::size_t first, std::size_t last,
                                                               std::size_t key,
                                                               base::WorkCounter& work) const {
    std::pair range{keys_[key][first], keys_[key][first]};
    work.in_pieces(first, last, [&](std::size_t begin, std::size_t end) {
      const auto piece = keys_[key].subspan(begin, end - begin);
      const auto [lowest, highest] = std::minmax_element(piece.begin(), piece.end());
      range = {std::min(range.first, *lowest), std::max(range.second, *highest)};
    });
    return range;
  }

  std::array<std::span<std::int32_t>, Keys> keys_;
};

}  // namespace abut::reference
