// Rows of pairs sorted in vectors, compiled once for each instruction set (Highway). The second
// elements of a short row fit a vector, which a network sorts without a branch to guess. In a
// longer row the place of a pair is the number of pairs there that come before it.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/order_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/order_kernels.hpp"

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
// Never chosen: abut::Simd::scalar sorts by insertion.
void sort_pairs(const PairRows&, ContactPair*) {}
void sort_words(const WordRows&, std::uint64_t*) {}
#else

/// Partners of the pairs of a row, and whole entries of 8 bytes.
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

/// Reads and writes rows of pairs: only their second elements are sorted.
class PairLanes {
 public:
  using Tag = NumberTag;
  using Entry = ContactPair;

  explicit PairLanes(const PairRows& rows) : first_element_(rows.first_element) {}

  HWY_INLINE static Values<Tag> load(const Entry* from) {
    Values<Tag> first;
    Values<Tag> second;
    hn::LoadInterleaved2(Tag(), reinterpret_cast<const std::uint32_t*>(from), first, second);
    return second;
  }
  HWY_INLINE void store(Values<Tag> second, std::uint32_t row, Entry* to) const {
    hn::StoreInterleaved2(hn::Set(Tag(), first_element_ + row), second, Tag(),
                          reinterpret_cast<std::uint32_t*>(to));
  }

 private:
  ElementIndex first_element_;
};

/// Reads and writes rows of entries that are sorted as they are.
class WordLanes {
 public:
  using Tag = WordTag;
  using Entry = std::uint64_t;

  explicit WordLanes(const WordRows&) {}

  HWY_INLINE static Values<Tag> load(const Entry* from) { return hn::LoadU(Tag(), from); }
  HWY_INLINE static void store(Values<Tag> values, std::uint32_t, Entry* to) {
    hn::StoreU(values, Tag(), to);
  }
};

/// Sorts `size` entries of a row, the first of which is number `begin`, in so many vectors. They
/// are written whole: what is written behind the row is overwritten by the next rows. Behind the
/// last row lie other entries, so that the last ones go through `last`.
template <std::size_t Vectors, class RowLanes, class Rows>
HWY_INLINE void sort_row(const RowLanes& lanes_of_row, const Rows& rows, std::uint32_t row,
                         std::uint32_t begin, std::uint32_t size, typename RowLanes::Entry* sorted,
                         typename RowLanes::Entry* last) {
  using Tag = typename RowLanes::Tag;
  constexpr std::uint32_t lanes = lanes_of<Tag>;
  constexpr std::uint32_t room = Vectors * lanes;
  constexpr Tag tag;
  Values<Tag> values[Vectors];
  for (std::uint32_t v = 0; v < Vectors; ++v) {
    const std::uint32_t before = v * lanes;
    const auto own = hn::FirstN(tag, size > before ? size - before : 0);
    const auto behind_all = hn::Not(hn::Zero(tag));
    values[v] = hn::IfThenElse(own, lanes_of_row.load(rows.entries + begin + before), behind_all);
  }
  sort_vectors<Vectors>(tag, values);
  auto* const place = begin + room <= rows.count ? sorted + begin : last;
  for (std::uint32_t v = 0; v < Vectors; ++v) lanes_of_row.store(values[v], row, place + v * lanes);
  if (place == last) std::copy_n(last, size, sorted + begin);
}

template <class RowLanes, class Rows>
HWY_INLINE void sort_all(const Rows& rows, typename RowLanes::Entry* sorted) {
  constexpr std::uint32_t lanes = lanes_of<typename RowLanes::Tag>;
  static_assert(longest_sorted_row == 16 * 4);
  typename RowLanes::Entry last[longest_sorted_row];
  const RowLanes lanes_of_row(rows);
  std::uint32_t begin = 0;
  for (std::uint32_t row = 0; row < rows.row_count; ++row) {
    const std::uint32_t size = rows.ends[row] - begin;
    if (size <= lanes) {
      sort_row<1>(lanes_of_row, rows, row, begin, size, sorted, last);
    } else if (size <= 2 * lanes) {
      sort_row<2>(lanes_of_row, rows, row, begin, size, sorted, last);
    } else if (size <= 4 * lanes) {
      sort_row<4>(lanes_of_row, rows, row, begin, size, sorted, last);
    } else if (size <= 8 * lanes) {
      sort_row<8>(lanes_of_row, rows, row, begin, size, sorted, last);
    } else if (size <= longest_sorted_row) {
      sort_row<longest_sorted_row / lanes>(lanes_of_row, rows, row, begin, size, sorted, last);
    } else {
      std::copy_n(rows.entries + begin, size, sorted + begin);
    }
    begin += size;
  }
}

void sort_pairs(const PairRows& rows, ContactPair* sorted) {
  sort_all<PairLanes>(rows, sorted);
}

void sort_words(const WordRows& rows, std::uint64_t* sorted) {
  // Vectors of two words are no faster than sorting by insertion.
  if constexpr (lanes_of<WordTag> >= 4) sort_all<WordLanes>(rows, sorted);
}

#endif

}  // namespace abut::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace abut::kernels {

HWY_EXPORT(sort_pairs);
HWY_EXPORT(sort_words);

OrderKernels simd_order_kernels(std::int64_t target) {
  hwy::ChosenTarget chosen;
  chosen.Update(target);
  constexpr std::int64_t wide = HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL;
  return {HWY_DISPATCH_TABLE(sort_pairs)[chosen.GetIndex()],
          (target & wide) != 0 ? HWY_DISPATCH_TABLE(sort_words)[chosen.GetIndex()] : nullptr};
}

}  // namespace abut::kernels
#endif
