#pragma once

#include <abut/pair.hpp>
#include <abut/simd.hpp>

#include <cstddef>
#include <cstdint>

namespace abut::kernels {

/// Pairs that lie together row by row: those of first element first_element + r end at ends[r].
struct PairRows {
  const ContactPair* pairs;  ///< readable `longest_sorted_row` beyond the last
  std::size_t count;
  ElementIndex first_element;
  const std::uint32_t* ends;  ///< of each row
  std::uint32_t row_count;
};

inline constexpr std::uint32_t longest_sorted_row = 64;

/// Orders of pairs in vectors.
struct OrderKernels {
  /// Writes the pairs with each row sorted by second elements, longer ones than longest_sorted_row
  /// as they are. Equal pairs may come. Null where there are no vectors.
  void (*sort_rows)(const PairRows& rows, ContactPair* sorted) = nullptr;
};

/// `level` must be available.
[[nodiscard]] OrderKernels order_kernels(Simd level);

/// `target` as Highway numbers instruction sets. Only where Highway is built in.
[[nodiscard]] OrderKernels simd_order_kernels(std::int64_t target);

}  // namespace abut::kernels
