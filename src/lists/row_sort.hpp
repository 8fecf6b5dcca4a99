#pragma once

#include "base/array.hpp"
#include "base/asking_sort.hpp"
#include "base/progress_reporter.hpp"
#include "kernels/order_kernels.hpp"
#include "lists/far_apart.hpp"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>

namespace abut::lists {

/// A number of a row of a range: a second element, or a packed entry.
template <class Number>
struct RowNumber {
  std::uint32_t row;
  Number number;

  friend constexpr auto operator<=>(const RowNumber&, const RowNumber&) = default;
};

/// Sorts the numbers of the rows of a range: each is written to a slot of its row, without a pass
/// that counts first, and vectors sort the rows (kernels::OrderKernels). The few numbers that find
/// no slot are added to their rows afterwards. It keeps its arrays.
template <class Number>
class RowSort {
 public:
  explicit RowSort(base::MemoryMeter& memory)
      : numbers_(base::make_array_for_overwrite<Number>(memory, 0)),
        sizes_(base::make_array_for_overwrite<std::uint32_t>(memory, 0)),
        excess_(base::make_array_for_overwrite<RowNumber<Number>>(memory, 0)) {}

  /// Takes number_at(k), a RowNumber, for each k of [0, count). False where that is not worth while
  /// for so many, or too many find no slot.
  template <class NumberAt>
  [[nodiscard]] bool take(std::size_t count, std::size_t rows, const NumberAt& number_at,
                          base::WorkCounter& work);

  /// The numbers that were taken, for a kernel that sorts them.
  [[nodiscard]] kernels::RowSlots<Number> slots() const noexcept {
    return {numbers_.data(), sizes_.data(), row_count_, std::uint32_t{1} << shift_, count_};
  }

  /// The length of each row.
  [[nodiscard]] std::span<const std::uint32_t> sizes() const noexcept {
    return std::span(sizes_).first(row_count_);
  }

  /// Adds what found no slot to the entries that a kernel sorted; entry_of(row, number) makes one.
  template <class Entry, class EntryOf>
  void add_excess(std::span<Entry> sorted, const EntryOf& entry_of, base::WorkCounter& work);

 private:
  /// Tells whether rows have numbers enough on average, since an empty one costs as much as some
  /// numbers, and not so many that a good part of them would be too long.
  [[nodiscard]] static bool suits(std::size_t count, std::size_t rows) noexcept {
    constexpr std::size_t most_on_average = 48;
    return 2 * count >= 3 * rows && count <= most_on_average * rows;
  }

  /// At least 8, and a few more than twice the average.
  [[nodiscard]] static int shift_for(std::size_t count, std::size_t rows) noexcept {
    int shift = 3;
    while ((std::size_t{1} << shift) < kernels::longest_sorted_row &&
           (rows << shift) < 2 * (count + rows)) {
      ++shift;
    }
    return shift;
  }

  base::Array<Number> numbers_;  ///< in slots
  base::Array<std::uint32_t> sizes_;
  base::Array<RowNumber<Number>> excess_;  ///< without a slot
  std::size_t excess_count_ = 0;
  std::size_t count_ = 0;
  std::uint32_t row_count_ = 0;
  int shift_ = 3;  ///< a row has 2^shift_ slots
};

template <class Number>
template <class NumberAt>
bool RowSort<Number>::take(std::size_t count, std::size_t rows, const NumberAt& number_at,
                           base::WorkCounter& work) {
  if (!suits(count, rows)) return false;
  constexpr std::size_t one_in = 8;
  count_ = count;
  row_count_ = static_cast<std::uint32_t>(rows);
  shift_ = shift_for(count, rows);
  const std::size_t most = count / one_in;
  base::make_room(numbers_, (rows << shift_) + kernels::longest_sorted_row);
  base::make_room(sizes_, rows);
  base::make_room(excess_, most);
  std::fill_n(sizes_.data(), rows, 0U);
  work.did(rows);
  std::size_t without_slot = 0;
  const auto put = [number_at, numbers = numbers_.data(), sizes = sizes_.data(),
                    excess = excess_.data(), shift = shift_, most, &without_slot](std::size_t k) {
    const auto [row, number] = number_at(k);
    const std::uint32_t slot = sizes[row]++;
    if (slot >> shift == 0) {
      numbers[(std::size_t{row} << shift) + slot] = number;
    } else if (const std::size_t place = without_slot++; place < most) {
      excess[place] = {row, number};
    }
  };
  for_each_far_apart(count, work, put);
  excess_count_ = std::min(without_slot, most);
  return without_slot <= most;
}

template <class Number>
template <class Entry, class EntryOf>
void RowSort<Number>::add_excess(std::span<Entry> sorted, const EntryOf& entry_of,
                                 base::WorkCounter& work) {
  if (excess_count_ == 0) return;
  const auto excess = std::span(excess_).first(excess_count_);
  base::sort_asking(excess.begin(), excess.end(), work);
  auto next = excess.begin();
  std::size_t begin = 0;
  for (std::uint32_t row = 0; row < row_count_; ++row) {
    const std::size_t end = begin + sizes_[row];
    if (std::size_t place = begin + (std::size_t{1} << shift_); place < end) {
      for (; place < end; ++place, ++next) sorted[place] = entry_of(row, next->number);
      const auto entries = sorted.subspan(begin, end - begin);
      base::sort_asking(entries.begin(), entries.end(), work);
    }
    begin = end;
  }
  work.did(row_count_);
}

}  // namespace abut::lists
