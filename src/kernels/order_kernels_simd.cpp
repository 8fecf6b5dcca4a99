// Rows of pairs sorted in vectors, compiled once for each instruction set (Highway). The second
// elements of a short row fit a vector, which a network sorts without a branch to guess. In a
// longer row the place of a pair is the number of pairs there that come before it.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/order_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/order_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
// Never chosen: abut::Simd::scalar sorts by insertion.
void sort_rows(const PairRows&, ContactPair*) {}
#else

using NumberTag = hn::CappedTag<std::uint32_t, 8>;
using Numbers = hn::Vec<NumberTag>;
constexpr NumberTag numbers{};
constexpr std::uint32_t lanes = hn::MaxLanes(NumberTag());

// Bitonic networks (K. E. Batcher, Sorting networks and their applications, 1968): of two sorted
// sequences, one of them in reverse, the lesser of each two numbers come before the greater ones,
// and both halves are merged likewise.

/// The greater numbers in lanes 1, 3, 5, 7, and the lesser ones in the others.
HWY_INLINE Numbers in_twos(Numbers lesser, Numbers greater) {
  return hn::OddEven(greater, lesser);
}
/// The greater numbers in lanes 2, 3, 6, 7, and the lesser ones in the others.
HWY_INLINE Numbers in_fours(Numbers lesser, Numbers greater) {
  constexpr hn::Repartition<std::uint64_t, NumberTag> twos;
  return hn::BitCast(numbers, hn::OddEven(hn::BitCast(twos, greater), hn::BitCast(twos, lesser)));
}

HWY_INLINE Numbers merged_twos(Numbers values) {
  const Numbers other = hn::Shuffle2301(values);
  return in_twos(hn::Min(values, other), hn::Max(values, other));
}
HWY_INLINE Numbers merged_fours(Numbers values) {
  const Numbers other = hn::Shuffle1032(values);
  return merged_twos(in_fours(hn::Min(values, other), hn::Max(values, other)));
}
/// Lanes that ascend and then descend, or the other way round, in order.
HWY_INLINE Numbers merged_lanes(Numbers values) {
  if constexpr (lanes == 8) {
    const Numbers other = hn::ConcatLowerUpper(numbers, values, values);
    values = hn::ConcatUpperLower(numbers, hn::Max(values, other), hn::Min(values, other));
  }
  return merged_fours(values);
}

HWY_INLINE Numbers sorted_lanes(Numbers values) {
  values = merged_twos(values);
  Numbers other = hn::Shuffle0123(values);
  values = merged_twos(in_fours(hn::Min(values, other), hn::Max(values, other)));
  if constexpr (lanes == 8) {
    other = hn::Reverse(numbers, values);
    values =
        merged_fours(hn::ConcatUpperLower(numbers, hn::Max(values, other), hn::Min(values, other)));
  }
  return values;
}

template <std::size_t Count>
HWY_INLINE void merge_vectors(Numbers* values) {
  if constexpr (Count == 1) {
    values[0] = merged_lanes(values[0]);
  } else {
    constexpr std::size_t half = Count / 2;
    for (std::size_t k = 0; k < half; ++k) {
      const Numbers lesser = hn::Min(values[k], values[half + k]);
      values[half + k] = hn::Max(values[k], values[half + k]);
      values[k] = lesser;
    }
    merge_vectors<half>(values);
    merge_vectors<half>(values + half);
  }
}

template <std::size_t Count>
HWY_INLINE void sort_vectors(Numbers* values) {
  if constexpr (Count == 1) {
    values[0] = sorted_lanes(values[0]);
  } else {
    constexpr std::size_t half = Count / 2;
    sort_vectors<half>(values);
    sort_vectors<half>(values + half);
    Numbers greater[half];
    for (std::size_t k = 0; k < half; ++k) {
      const Numbers other = hn::Reverse(numbers, values[Count - 1 - k]);
      greater[k] = hn::Max(values[k], other);
      values[k] = hn::Min(values[k], other);
    }
    for (std::size_t k = 0; k < half; ++k) values[half + k] = greater[k];
    merge_vectors<half>(values);
    merge_vectors<half>(values + half);
  }
}

/// Sorts `size` pairs of a row, the first of which is number `begin`, in so many vectors. They are
/// written whole: what is written behind the row is overwritten by the next rows. Behind the last
/// row lie other pairs, so that the last ones go through `last`.
template <std::size_t Vectors>
HWY_INLINE void sort_row(const PairRows& rows, std::uint32_t row, std::uint32_t begin,
                         std::uint32_t size, ContactPair* sorted, ContactPair* last) {
  constexpr std::uint32_t room = Vectors * lanes;
  const auto* const pairs = reinterpret_cast<const std::uint32_t*>(rows.pairs + begin);
  Numbers second[Vectors];
  Numbers first;
  for (std::uint32_t v = 0; v < Vectors; ++v) {
    hn::LoadInterleaved2(numbers, pairs + 2 * v * lanes, first, second[v]);
    const std::uint32_t before = v * lanes;
    const auto own = hn::FirstN(numbers, size > before ? size - before : 0);
    second[v] = hn::IfThenElse(own, second[v], hn::Set(numbers, ~std::uint32_t{0}));
  }
  sort_vectors<Vectors>(second);
  first = hn::Set(numbers, rows.first_element + row);
  ContactPair* const place = begin + room <= rows.count ? sorted + begin : last;
  for (std::uint32_t v = 0; v < Vectors; ++v) {
    hn::StoreInterleaved2(first, second[v], numbers,
                          reinterpret_cast<std::uint32_t*>(place + v * lanes));
  }
  if (place == last) std::copy_n(last, size, sorted + begin);
}

void sort_rows(const PairRows& rows, ContactPair* sorted) {
  static_assert(longest_sorted_row == 16 * 4);
  ContactPair last[longest_sorted_row];
  std::uint32_t begin = 0;
  for (std::uint32_t row = 0; row < rows.row_count; ++row) {
    const std::uint32_t size = rows.ends[row] - begin;
    if (size <= lanes) {
      sort_row<1>(rows, row, begin, size, sorted, last);
    } else if (size <= 2 * lanes) {
      sort_row<2>(rows, row, begin, size, sorted, last);
    } else if (size <= 4 * lanes) {
      sort_row<4>(rows, row, begin, size, sorted, last);
    } else if (size <= 8 * lanes) {
      sort_row<8>(rows, row, begin, size, sorted, last);
    } else if (size <= longest_sorted_row) {
      sort_row<longest_sorted_row / lanes>(rows, row, begin, size, sorted, last);
    } else {
      std::copy_n(rows.pairs + begin, size, sorted + begin);
    }
    begin += size;
  }
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(sort_rows);

OrderKernels simd_order_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  return {HWY_DISPATCH_TABLE(sort_rows)[chosen.GetIndex()]};
}

}  // namespace abut::kernels
#endif
