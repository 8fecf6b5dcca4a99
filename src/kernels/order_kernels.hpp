#pragma once

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Most numbers of a row that vectors sort.
inline constexpr std::uint32_t longest_sorted_row = 64;

/// Numbers of rows, each row in slots of its own:
///
///   row         0                 1                 2
///   numbers   | a b c . . . . . | d . . . . . . . | e f g h i j k l |      capacity 8
///   sizes       3                 1                 10
///
/// A row may have more numbers than slots; those in excess are kept elsewhere.
template <class Number>
struct RowSlots {
  const Number* numbers;       ///< readable `longest_sorted_row` beyond the last
  const std::uint32_t* sizes;  ///< of each row, numbers in excess included
  std::uint32_t row_count;
  std::uint32_t capacity;  ///< of each row, at most longest_sorted_row
  std::size_t count;       ///< of all numbers, those in excess included

  [[nodiscard]] std::uint32_t longest() const { return capacity; }
  [[nodiscard]] std::uint32_t size(std::uint32_t row, std::uint32_t) const { return sizes[row]; }
  [[nodiscard]] const Number* first(std::uint32_t row, std::uint32_t) const {
    return numbers + std::size_t{row} * capacity;
  }
};

using NumberSlots = RowSlots<std::uint32_t>;
using WordSlots = RowSlots<std::uint64_t>;

/// Numbers of 8 bytes that lie together row by row: those of row r end at ends[r].
struct WordRows {
  const std::uint64_t* numbers;  ///< readable `longest_sorted_row` beyond the last
  const std::uint32_t* ends;
  std::uint32_t row_count;
  std::size_t count;

  [[nodiscard]] static std::uint32_t longest() { return longest_sorted_row; }
  [[nodiscard]] std::uint32_t size(std::uint32_t row, std::uint32_t begin) const {
    return ends[row] - begin;
  }
  [[nodiscard]] const std::uint64_t* first(std::uint32_t, std::uint32_t begin) const {
    return numbers + begin;
  }
};

/// Orders of rows in vectors. Each writes the numbers of all rows one after the other, every row in
/// ascending order. Of a row that is longer than longest(), as many numbers as that are written, in
/// any order, and room is left for the others. Equal numbers may come. Null where there are no
/// vectors for it.
struct OrderKernels {
  /// Second elements of first element first_element + r in row r, as pairs.
  void (*sort_pairs)(const NumberSlots& rows, ElementIndex first_element,
                     ContactPair* sorted) = nullptr;
  void (*sort_numbers)(const NumberSlots& rows, std::uint32_t* sorted) = nullptr;
  void (*sort_words)(const WordSlots& rows, std::uint64_t* sorted) = nullptr;
  void (*sort_word_rows)(const WordRows& rows, std::uint64_t* sorted) = nullptr;
};

/// `level` must be available.
[[nodiscard]] OrderKernels order_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] OrderKernels simd_order_kernels(std::int64_t target);

}  // namespace abut::kernels
