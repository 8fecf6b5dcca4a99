// Rows of numbers sorted in vectors, compiled once for each instruction set (Highway). A network
// sorts the numbers of a row, which fit a few vectors, without a branch to guess.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/order_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/order_kernels.hpp"
#include "kernels/table_index.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
// Never chosen: abut::Simd::scalar sorts by insertion.
void sort_pairs(const NumberSlots&, ElementIndex, ContactPair*) {}
void sort_numbers(const NumberSlots&, std::uint32_t*) {}
void sort_words(const WordSlots&, std::uint64_t*) {}
void sort_word_rows(const WordRows&, std::uint64_t*) {}
#else

/// Second elements of pairs, and whole entries of 8 bytes.
using NumberTag = hn::CappedTag<std::uint32_t, 8>;
using WordTag = hn::CappedTag<std::uint64_t, 8>;
template <class Tag>
using Values = hn::Vec<Tag>;
template <class Tag>
constexpr std::uint32_t lanes_of = hn::MaxLanes(Tag());

// Bitonic networks (K. E. Batcher, Sorting networks and their applications, 1968): of two sorted
// sequences, one of them in reverse, the lesser of each two numbers come before the greater ones,
// and both halves are merged likewise.

/// The greater numbers in lanes 2, 3, 6, 7, and the lesser ones in the others.
template <class Tag>
HWY_INLINE Values<Tag> in_fours(Tag tag, Values<Tag> lesser, Values<Tag> greater) {
  if constexpr (std::same_as<Tag, WordTag>) {
    return hn::OddEvenBlocks(greater, lesser);
  } else {
    constexpr hn::Repartition<std::uint64_t, Tag> twos;
    return hn::BitCast(tag, hn::OddEven(hn::BitCast(twos, greater), hn::BitCast(twos, lesser)));
  }
}
/// The greater numbers in lanes 4 to 7, and the lesser ones in the others.
template <class Tag>
HWY_INLINE Values<Tag> in_eights(Tag tag, Values<Tag> lesser, Values<Tag> greater) {
  return hn::ConcatUpperLower(tag, greater, lesser);
}

/// Lanes 2, 3, 0, 1, 6, 7, 4, 5.
template <class Tag>
HWY_INLINE Values<Tag> swapped_twos(Values<Tag> values) {
  if constexpr (std::same_as<Tag, WordTag>) {
    return hn::SwapAdjacentBlocks(values);
  } else {
    return hn::Shuffle1032(values);
  }
}

template <class Tag>
HWY_INLINE Values<Tag> merged_twos(Tag tag, Values<Tag> values) {
  const auto other = hn::Reverse2(tag, values);
  return hn::OddEven(hn::Max(values, other), hn::Min(values, other));
}
template <class Tag>
HWY_INLINE Values<Tag> merged_fours(Tag tag, Values<Tag> values) {
  const auto other = swapped_twos<Tag>(values);
  return merged_twos(tag, in_fours(tag, hn::Min(values, other), hn::Max(values, other)));
}
/// Lanes that ascend and then descend, or the other way round, in order.
template <class Tag>
HWY_INLINE Values<Tag> merged_lanes(Tag tag, Values<Tag> values) {
  if constexpr (lanes_of<Tag> == 8) {
    const auto other = hn::ConcatLowerUpper(tag, values, values);
    values = in_eights(tag, hn::Min(values, other), hn::Max(values, other));
  }
  return merged_fours(tag, values);
}

template <class Tag>
HWY_INLINE Values<Tag> sorted_lanes(Tag tag, Values<Tag> values) {
  values = merged_twos(tag, values);
  auto other = hn::Reverse4(tag, values);
  values = merged_twos(tag, in_fours(tag, hn::Min(values, other), hn::Max(values, other)));
  if constexpr (lanes_of<Tag> == 8) {
    other = hn::Reverse(tag, values);
    values = merged_fours(tag, in_eights(tag, hn::Min(values, other), hn::Max(values, other)));
  }
  return values;
}

template <std::size_t Count, class Tag>
HWY_INLINE void merge_vectors(Tag tag, Values<Tag>* values) {
  if constexpr (Count == 1) {
    values[0] = merged_lanes(tag, values[0]);
  } else {
    constexpr std::size_t half = Count / 2;
    for (std::size_t k = 0; k < half; ++k) {
      const auto lesser = hn::Min(values[k], values[half + k]);
      values[half + k] = hn::Max(values[k], values[half + k]);
      values[k] = lesser;
    }
    merge_vectors<half>(tag, values);
    merge_vectors<half>(tag, values + half);
  }
}

template <std::size_t Count, class Tag>
HWY_INLINE void sort_vectors(Tag tag, Values<Tag>* values) {
  if constexpr (Count == 1) {
    values[0] = sorted_lanes(tag, values[0]);
  } else {
    constexpr std::size_t half = Count / 2;
    sort_vectors<half>(tag, values);
    sort_vectors<half>(tag, values + half);
    Values<Tag> greater[half];
    for (std::size_t k = 0; k < half; ++k) {
      const auto other = hn::Reverse(tag, values[Count - 1 - k]);
      greater[k] = hn::Max(values[k], other);
      values[k] = hn::Min(values[k], other);
    }
    for (std::size_t k = 0; k < half; ++k) values[half + k] = greater[k];
    merge_vectors<half>(tag, values);
    merge_vectors<half>(tag, values + half);
  }
}

// What is written of the numbers of a row.

/// The numbers themselves.
template <class NumberOfTag>
struct WriteNumbers {
  using Tag = NumberOfTag;
  using Entry = hn::TFromD<Tag>;

  HWY_INLINE static void store(Values<Tag> values, std::uint32_t, Entry* to) {
    hn::StoreU(values, Tag(), to);
  }
  HWY_INLINE static Entry entry(std::uint32_t, Entry number) { return number; }
};

/// Pairs, whose second elements the numbers are.
struct WritePairs {
  using Tag = NumberTag;
  using Entry = ContactPair;

  HWY_INLINE void store(Values<Tag> second, std::uint32_t row, Entry* to) const {
    hn::StoreInterleaved2(hn::Set(Tag(), first_element + row), second, Tag(),
                          reinterpret_cast<std::uint32_t*>(to));
  }
  [[nodiscard]] HWY_INLINE Entry entry(std::uint32_t row, std::uint32_t second) const {
    return {first_element + row, second};
  }

  ElementIndex first_element;
};

/// Sorts `size` numbers of a row, which are written from place `begin` on, in so many vectors.
/// These are written whole: what is written behind the row is overwritten by the next rows. Behind
/// the last row lie the entries of others, so that the last ones go through `last`.
template <std::size_t Vectors, class Write, class Rows>
HWY_INLINE void sort_row(const Write& write, const Rows& rows, std::uint32_t row,
                         std::uint32_t begin, std::uint32_t size, typename Write::Entry* sorted,
                         typename Write::Entry* last) {
  using Tag = typename Write::Tag;
  constexpr std::uint32_t lanes = lanes_of<Tag>;
  constexpr std::uint32_t room = Vectors * lanes;
  constexpr Tag tag;
  const auto* const numbers = rows.first(row, begin);
  Values<Tag> values[Vectors];
  for (std::uint32_t v = 0; v < Vectors; ++v) {
    const std::uint32_t before = v * lanes;
    const auto own = hn::FirstN(tag, size > before ? size - before : 0);
    const auto behind_all = hn::Not(hn::Zero(tag));
    values[v] = hn::IfThenElse(own, hn::LoadU(tag, numbers + before), behind_all);
  }
  sort_vectors<Vectors>(tag, values);
  auto* const place = begin + room <= rows.count ? sorted + begin : last;
  for (std::uint32_t v = 0; v < Vectors; ++v) write.store(values[v], row, place + v * lanes);
  if (place == last) std::copy_n(last, std::min(size, room), sorted + begin);
}

template <class Write, class Rows>
HWY_INLINE void sort_all(const Write& write, const Rows& rows, typename Write::Entry* sorted) {
  constexpr std::uint32_t lanes = lanes_of<typename Write::Tag>;
  static_assert(longest_sorted_row == 16 * 4);
  typename Write::Entry last[longest_sorted_row];
  std::uint32_t begin = 0;
  for (std::uint32_t row = 0; row < rows.row_count; ++row) {
    const std::uint32_t size = rows.size(row, begin);
    if (size > rows.longest()) {
      const auto* const numbers = rows.first(row, begin);
      for (std::uint32_t k = 0; k < rows.longest(); ++k) {
        sorted[begin + k] = write.entry(row, numbers[k]);
      }
    } else if (size <= lanes) {
      sort_row<1>(write, rows, row, begin, size, sorted, last);
    } else if (size <= 2 * lanes) {
      sort_row<2>(write, rows, row, begin, size, sorted, last);
    } else if (size <= 4 * lanes) {
      sort_row<4>(write, rows, row, begin, size, sorted, last);
    } else if (size <= 8 * lanes) {
      sort_row<8>(write, rows, row, begin, size, sorted, last);
    } else {
      sort_row<longest_sorted_row / lanes>(write, rows, row, begin, size, sorted, last);
    }
    begin += size;
  }
}

void sort_pairs(const NumberSlots& rows, ElementIndex first_element, ContactPair* sorted) {
  sort_all(WritePairs{first_element}, rows, sorted);
}

void sort_numbers(const NumberSlots& rows, std::uint32_t* sorted) {
  sort_all(WriteNumbers<NumberTag>(), rows, sorted);
}

// Vectors of two words are no faster than sorting by insertion.
void sort_words(const WordSlots& rows, std::uint64_t* sorted) {
  if constexpr (lanes_of<WordTag> >= 4) sort_all(WriteNumbers<WordTag>(), rows, sorted);
}

void sort_word_rows(const WordRows& rows, std::uint64_t* sorted) {
  if constexpr (lanes_of<WordTag> >= 4) sort_all(WriteNumbers<WordTag>(), rows, sorted);
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(sort_pairs);
HWY_EXPORT(sort_numbers);
HWY_EXPORT(sort_words);
HWY_EXPORT(sort_word_rows);

OrderKernels simd_order_kernels(std::int64_t target) {
  const std::size_t here = table_index(target);
  OrderKernels kernels{HWY_DISPATCH_TABLE(sort_pairs)[here], HWY_DISPATCH_TABLE(sort_numbers)[here],
                       nullptr, nullptr};
  constexpr std::int64_t wide = HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL;
  if ((target & wide) == 0) return kernels;
  kernels.sort_words = HWY_DISPATCH_TABLE(sort_words)[here];
  kernels.sort_word_rows = HWY_DISPATCH_TABLE(sort_word_rows)[here];
  return kernels;
}

}  // namespace abut::kernels
#endif
