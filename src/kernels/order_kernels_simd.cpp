// Rows of pairs sorted in vectors, compiled once for each instruction set (Highway). The place of a
// pair in its row is the number of pairs there that come before it: one comparison of whole
// vectors, and no branch to guess.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/order_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "kernels/order_kernels.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace abut::kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A pair is a word. Pairs of one row have the same first element, so that their words are ordered
/// as their second ones are, whichever half of a word comes first.
using WordTag = hn::CappedTag<std::uint64_t, 8>;
using Mask = hn::Mask<WordTag>;
constexpr WordTag words{};
constexpr std::size_t lanes = hn::MaxLanes(WordTag());

HWY_INLINE std::uint32_t bits_of(Mask mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(words, mask, bits);
  return bits[0];
}

/// The lowest `count` bits of 32, up to all.
HWY_INLINE std::uint32_t lowest(std::uint32_t count) {
  return static_cast<std::uint32_t>((std::uint64_t{1} << count) - 1);
}

void sort_rows(const PairRows& rows, ContactPair* sorted) {
  const auto* const pairs = reinterpret_cast<const std::uint64_t*>(rows.pairs);
  for (std::size_t k = 0; k < rows.count; ++k) {
    const std::uint32_t row = rows.pairs[k].first - rows.first_element;
    const std::uint32_t begin = row == 0 ? 0 : rows.ends[row - 1];
    const std::uint32_t size = rows.ends[row] - begin;
    const auto own = hn::Set(words, std::bit_cast<std::uint64_t>(rows.pairs[k]));
    std::uint32_t less = 0;
    std::uint32_t equal = 0;
    for (std::uint32_t lane = 0; lane < size; lane += lanes) {
      const auto others = hn::LoadU(words, pairs + begin + lane);
      less |= bits_of(hn::Lt(others, own)) << lane;
      equal |= bits_of(hn::Eq(others, own)) << lane;
    }
    const std::uint32_t before = lowest(static_cast<std::uint32_t>(k) - begin);
    const std::uint32_t smaller = (less | (equal & before)) & lowest(size);
    sorted[begin + static_cast<std::uint32_t>(std::popcount(smaller))] = rows.pairs[k];
  }
}

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
