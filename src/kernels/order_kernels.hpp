#pragma once

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Entries that lie together row by row: those of row r end at ends[r].
template <class Entry>
struct SortedByRow {
  const Entry* entries;  ///< readable `longest_sorted_row` beyond the last
  std::size_t count;
  const std::uint32_t* ends;  ///< of each row
  std::uint32_t row_count;
};

/// Pairs, of first element first_element + r in row r.
struct PairRows : SortedByRow<ContactPair> {
  ElementIndex first_element;
};

/// Entries of 8 bytes, whose order is that of the whole numbers that they are.
using WordRows = SortedByRow<std::uint64_t>;

inline constexpr std::uint32_t longest_sorted_row = 64;

/// Orders of entries in vectors. Each writes the entries with every row sorted, pairs by second
/// elements, and rows longer than longest_sorted_row as they are. Equal entries may come. Null
/// where there are no vectors for it.
struct OrderKernels {
  void (*sort_pairs)(const PairRows& rows, ContactPair* sorted) = nullptr;
  void (*sort_words)(const WordRows& rows, std::uint64_t* sorted) = nullptr;
};

/// `level` must be available.
[[nodiscard]] OrderKernels order_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] OrderKernels simd_order_kernels(std::int64_t target);

}  // namespace abut::kernels
